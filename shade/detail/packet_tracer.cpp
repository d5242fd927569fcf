// SPDX-License-Identifier: MIT
#include "shade/detail/packet_tracer.h"

#include <algorithm>
#include <cmath>

#include "shade/detail/shading_lanes.h"

namespace csgcast::detail {

bool PacketTracer::suits(const Scene& scene, const View& view, const Camera& camera) {
  const CameraFrame& frame = camera.frame();
  const double reach = longest(as_vector(frame.eye)) + frame.pixel * (frame.width + frame.height);
  return !scene.transmits() && view.settings.max_depth > 0 && reach < 0.5 * Ray::greatest;
}

PacketTracer::PacketTracer(const Cells& cells, const View& view, const Camera& camera, Tracer& tracer)
    : scene_(cells.scene()), view_(view), camera_(camera), tracer_(tracer), caster_(cells) {
  for (const Material& look : scene_.looks()) {
    mirrors_.push_back(look.reflection > 0 ? 1 : 0);
    has_mirrors_ = has_mirrors_ || look.reflection > 0;
  }
}

RenderReport PacketTracer::report() const {
  RenderReport report = report_;
  report.casts += caster_.caster_counts();
  report.packets += caster_.counts();
  return report;
}

void PacketTracer::resize(std::size_t count) {
  if (t_.size() >= count) return;
  constexpr std::size_t more = 8;  // stores of whole registers reach beyond
  for (Vectors* vectors : {&origin_, &direction_, &point_, &normal_, &color_, &shadow_origin_, &path_, &light_}) {
    for (Numbers& numbers : *vectors) numbers.resize(count + more);
  }
  for (auto* list : {&surface_, &look_, &sample_, &departure_}) list->resize(count);
  for (auto* list : {&state_, &comes_positive_, &is_plain_, &departs_positive_, &blocked_}) list->resize(count);
  t_.resize(count);
  ones_.resize(count, 1.0);
}

void PacketTracer::trace(std::span<const double> x, std::span<const double> y, std::span<Rgb> colors) {
  if (x.empty()) return;
  resize(x.size());
  see(x, y);
  if (!sort_out(colors)) return;
  const ShadingPoints points{x.size(),
                             is_plain_.data(),
                             {point_[0].data(), point_[1].data(), point_[2].data()},
                             {normal_[0].data(), normal_[1].data(), normal_[2].data()},
                             {direction_[0].data(), direction_[1].data(), direction_[2].data()},
                             look_.data()};
  shading_code().unlit(scene_.looks().data(), points, pointers(color_).data());
  for (const LightDescription& light : view_.lights) add_light(light, points);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (is_plain_[i] != 0) colors[i] = {color_[0][i], color_[1][i], color_[2][i]};
  }
}

// What each sample's ray meets.
void PacketTracer::see(std::span<const double> x, std::span<const double> y) {
  shading_code().camera_rays(camera_.frame(), x.size(), x.data(), y.data(), pointers(origin_).data(),
                             pointers(direction_).data());
  RayArrays rays;
  rays.count = x.size();
  FaceArrays faces;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rays.origin[axis] = origin_[axis].data();
    rays.direction[axis] = direction_[axis].data();
    faces.point[axis] = point_[axis].data();
    faces.normal[axis] = normal_[axis].data();
  }
  faces.state = state_.data();
  faces.t = t_.data();
  faces.surface = surface_.data();
  faces.look = look_.data();
  faces.comes_positive = comes_positive_.data();
  caster_.first_faces(rays, faces);
}

// Samples that see nothing get the background, those that see more than an opaque face without a mirror, from outside,
// go to the tracer; the others are plain. Whether there are any.
bool PacketTracer::sort_out(std::span<Rgb> colors) {
  std::uint64_t plain = 0;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const bool is_plain = state_[i] == FaceArrays::entry && !(has_mirrors_ && mirrors_[look_[i]] != 0);
    is_plain_[i] = is_plain ? 1 : 0;
    plain += is_plain_[i];
    if (is_plain) continue;
    if (state_[i] == FaceArrays::none) {
      ++report_.rays.primary;
      colors[i] = view_.background;
    } else {
      trace_alone(i, colors[i]);
    }
  }
  // Lanes tell of no place that is not finite.
  for (const std::uint32_t i : caster_.left_to_caster()) {
    if (is_plain_[i] == 0 || std::isfinite(point_[0][i] + point_[1][i] + point_[2][i])) continue;
    is_plain_[i] = 0;
    --plain;
    trace_alone(i, colors[i]);
  }
  report_.rays.primary += plain;
  return plain > 0;
}

void PacketTracer::trace_alone(std::size_t sample, Rgb& color) {
  color = tracer_.trace({{origin_[0][sample], origin_[1][sample], origin_[2][sample]},
                         {direction_[0][sample], direction_[1][sample], direction_[2][sample]}});
}

// Adds what a light brings where nothing is in its way.
void PacketTracer::add_light(const LightDescription& light, const ShadingPoints& points) {
  ShadowRays shadows;
  std::copy_n(pointers(shadow_origin_).begin(), 3, shadows.origin);
  std::copy_n(pointers(path_).begin(), 3, shadows.path);
  std::copy_n(pointers(light_).begin(), 3, shadows.light);
  shadows.sample = sample_.data();
  shading_code().light(scene_.looks().data(), light, points, shadows);
  report_.skipped.shadow_facing_away += shadows.facing_away;
  report_.skipped.shadow_without_effect += shadows.without_effect;
  report_.rays.shadow += shadows.count;
  if (shadows.count == 0) return;
  for (std::size_t ray = 0; ray < shadows.count; ++ray) {
    departure_[ray] = surface_[sample_[ray]];
    departs_positive_[ray] = comes_positive_[sample_[ray]];
  }
  RayArrays rays;
  rays.count = shadows.count;
  std::copy_n(shadows.origin, 3, rays.origin);
  std::copy_n(shadows.path, 3, rays.direction);
  rays.departure = departure_.data();
  rays.departs_positive = departs_positive_.data();
  rays.end = light.position ? ones_.data() : nullptr;
  caster_.any_hits(rays, blocked_.data());
  for (std::size_t ray = 0; ray < shadows.count; ++ray) {
    if (blocked_[ray] != 0) continue;
    for (std::size_t channel = 0; channel < 3; ++channel) color_[channel][sample_[ray]] += light_[channel][ray];
  }
}

}  // namespace csgcast::detail
