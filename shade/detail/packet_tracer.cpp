// SPDX-License-Identifier: MIT
#include "shade/detail/packet_tracer.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "shade/detail/shading_lanes.h"

namespace csgcast::detail {

bool PacketTracer::suits(const Scene& scene, const View& view, const Camera& camera) {
  const CameraFrame& frame = camera.frame();
  const double reach = longest(as_vector(frame.eye)) + frame.pixel * (frame.width + frame.height);
  return !scene.transmits() && view.settings.max_depth > 0 && reach < 0.5 * Ray::greatest;
}

PacketTracer::PacketTracer(const Cells& cells, const View& view, const Camera& camera, Tracer& tracer)
    : scene_(cells.scene()), view_(view), camera_(camera), tracer_(tracer), caster_(cells) {
  for (const Material& look : scene_.looks()) mirrors_.push_back(look.reflection > 0 ? 1 : 0);
}

RenderReport PacketTracer::report() const {
  RenderReport report = report_;
  report.casts += caster_.caster_counts();
  report.packets += caster_.counts();
  return report;
}

void PacketTracer::resize(std::size_t count) {
  if (t_.size() >= count) return;
  for (Vectors* vectors : {&origin_, &direction_, &point_, &normal_, &hit_point_, &hit_normal_, &hit_direction_,
                           &color_, &light_, &path_, &shadow_origin_, &shadow_direction_}) {
    for (Numbers& numbers : *vectors) numbers.resize(count);
  }
  for (auto* list : {&surface_, &look_, &sample_, &hit_look_, &shaded_, &departure_}) list->resize(count);
  for (auto* list : {&state_, &comes_positive_, &effect_, &departs_positive_, &blocked_}) list->resize(count);
  t_.resize(count);
  ones_.resize(count, 1.0);
}

void PacketTracer::trace(std::span<const double> x, std::span<const double> y, std::span<Rgb> colors) {
  if (x.empty()) return;
  resize(x.size());
  see(x, y);
  sort_out(colors);
  if (sample_.empty()) return;
  const ShadingPoints points{sample_.size(),
                             {hit_point_[0].data(), hit_point_[1].data(), hit_point_[2].data()},
                             {hit_normal_[0].data(), hit_normal_[1].data(), hit_normal_[2].data()},
                             {hit_direction_[0].data(), hit_direction_[1].data(), hit_direction_[2].data()},
                             hit_look_.data()};
  const Material* looks = scene_.looks().data();
  shading_code().unlit(looks, points, pointers(color_).data());
  for (const LightDescription& light : view_.lights) {
    LightArrays lit;
    lit.effect = effect_.data();
    std::copy_n(pointers(light_).begin(), 3, lit.light);
    std::copy_n(pointers(path_).begin(), 3, lit.path);
    shading_code().light(looks, light, points, lit);
    add_light(light);
  }
  for (std::size_t k = 0; k < sample_.size(); ++k) colors[sample_[k]] = {color_[0][k], color_[1][k], color_[2][k]};
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
  sample_.resize(x.size());
  std::iota(sample_.begin(), sample_.end(), 0u);
}

// An opaque face without a mirror, seen from outside.
bool PacketTracer::is_plain(std::size_t i) const {
  return state_[i] == FaceArrays::entry && mirrors_[look_[i]] == 0 &&
         std::isfinite(point_[0][i] + point_[1][i] + point_[2][i]);
}

// Samples that see nothing get the background, those that see more than packets can shade go to the tracer; the others
// are put close together.
void PacketTracer::sort_out(std::span<Rgb> colors) {
  std::size_t kept = 0;
  for (const std::uint32_t i : sample_) {
    if (state_[i] == FaceArrays::none) {
      ++report_.rays.primary;
      colors[i] = view_.background;
      continue;
    }
    if (!is_plain(i)) {
      colors[i] = tracer_.trace({{origin_[0][i], origin_[1][i], origin_[2][i]},
                                 {direction_[0][i], direction_[1][i], direction_[2][i]}});
      continue;
    }
    ++report_.rays.primary;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      hit_point_[axis][kept] = point_[axis][i];
      hit_normal_[axis][kept] = normal_[axis][i];
      hit_direction_[axis][kept] = direction_[axis][i];
    }
    hit_look_[kept] = look_[i];
    sample_[kept++] = i;
  }
  sample_.resize(kept);
}

// Adds what a light brings where nothing is in its way.
void PacketTracer::add_light(const LightDescription& light) {
  std::size_t rays = 0;
  for (std::size_t k = 0; k < sample_.size(); ++k) {
    const auto effect = static_cast<LightEffect>(effect_[k]);
    report_.skipped.shadow_facing_away += effect == LightEffect::facing_away ? 1 : 0;
    report_.skipped.shadow_without_effect += effect == LightEffect::none ? 1 : 0;
    if (effect != LightEffect::some) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      shadow_origin_[axis][rays] = hit_point_[axis][k];
      shadow_direction_[axis][rays] = path_[axis][k];
    }
    departure_[rays] = surface_[sample_[k]];
    departs_positive_[rays] = comes_positive_[sample_[k]];
    shaded_[rays++] = static_cast<std::uint32_t>(k);
  }
  report_.rays.shadow += rays;
  RayArrays shadows;
  shadows.count = rays;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    shadows.origin[axis] = shadow_origin_[axis].data();
    shadows.direction[axis] = shadow_direction_[axis].data();
  }
  shadows.departure = departure_.data();
  shadows.departs_positive = departs_positive_.data();
  shadows.end = light.position ? ones_.data() : nullptr;
  caster_.any_hits(shadows, blocked_.data());
  for (std::size_t ray = 0; ray < rays; ++ray) {
    if (blocked_[ray] != 0) continue;
    const std::uint32_t k = shaded_[ray];
    for (std::size_t channel = 0; channel < 3; ++channel) color_[channel][k] += light_[channel][k];
  }
}

}  // namespace csgcast::detail
