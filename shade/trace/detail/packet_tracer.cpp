// SPDX-License-Identifier: MIT
#include "shade/trace/detail/packet_tracer.h"

#include <algorithm>
#include <cmath>

#include "csg/base/length.h"
#include "csg/base/precondition.h"
#include "shade/film/samples.h"
#include "shade/light/phong.h"
#include "shade/trace/detail/shading_lanes.h"

namespace csgcast::detail {

bool PacketTracer::suits(const Scene& scene, const View& view, const Camera& camera) {
  return !scene.transmits() && view.settings.max_depth > 0 && camera.rays_are_in_range();
}

PacketTracer::PacketTracer(const Cells& cells, const View& view, const Camera& camera, Tracer& tracer,
                           std::string_view instructions)
    : code_(shading_code(instructions)),
      scene_(cells.scene()),
      view_(view),
      camera_(camera),
      tracer_(tracer),
      caster_(cells, PacketCaster::Width::packet, instructions) {
  CSGCAST_PRECONDITION(suits(scene_, view, camera));
  for (const Material& look : scene_.looks()) has_mirrors_ = has_mirrors_ || look.reflection > 0;
}

RenderReport PacketTracer::report() const {
  RenderReport report = report_;
  report.casts += caster_.caster_counts();
  report.packets += caster_.counts();
  return report;
}

void PacketTracer::resize(std::size_t count) {
  if (ones_.size() >= count) return;
  faces_.resize(count);
  for (Vectors* vectors : {&origin_, &direction_, &color_, &shadow_origin_, &path_, &light_}) {
    for (Numbers& numbers : *vectors) numbers.resize(count + FaceBuffers::more);
  }
  for (auto* list : {&sample_, &departure_, &ray_place_, &ray_departure_}) list->resize(count);
  for (auto* list : {&departs_positive_, &blocked_, &ray_departs_positive_}) list->resize(count);
  for (auto* list : {&is_plain_, &leads_away_}) list->resize(count + FaceBuffers::more);
  weight_.resize(count);
  ones_.resize(count, 1.0);
}

void PacketTracer::trace(const Samples& samples, std::span<Rgb> colors) {
  if (samples.x.empty()) return;
  resize(samples.x.size());
  depth_ = 0;
  count_ = samples.x.size();
  code_.camera_rays(camera_.frame(), count_, samples.x.data(), samples.y.data(), pointers(origin_).data(),
                    pointers(direction_).data());
  std::copy(samples.place.begin(), samples.place.end(), ray_place_.begin());
  for (; count_ > 0; ++depth_) {
    see();
    const bool any_is_plain = sort_out(colors);
    if (any_is_plain) shade(colors);
    if (!any_is_plain || !has_mirrors_) return;
    reflect(colors);
  }
}

// What each ray meets.
void PacketTracer::see() {
  RayArrays rays;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rays.origin[axis] = {origin_[axis].data(), count_};
    rays.direction[axis] = {direction_[axis].data(), count_};
  }
  if (depth_ > 0) {
    rays.departure = {ray_departure_.data(), count_};
    rays.departs_positive = {ray_departs_positive_.data(), count_};
  }
  caster_.first_faces(rays, faces_.arrays());
}

// Rays that see nothing get the background, those that see an opaque face from inside go to the tracer; the others are
// plain. Whether there are any.
bool PacketTracer::sort_out(std::span<Rgb> colors) {
  const auto end = std::transform(faces_.state.begin(), faces_.state.begin() + static_cast<std::ptrdiff_t>(count_),
                                  is_plain_.begin(), [](std::uint8_t state) { return state == FaceArrays::entry; });
  auto plain = static_cast<std::uint64_t>(std::count(is_plain_.begin(), end, 1));
  std::uint64_t counted = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    if (is_plain_[i] != 0) continue;
    if (faces_.state[i] == FaceArrays::none) {
      ++counted;
      leave(i, colors[ray_place_[i]]);
    } else {
      trace_alone(i, colors[ray_place_[i]]);
    }
  }
  // Lanes tell of no place that is not finite.
  for (const std::uint32_t i : caster_.left_to_caster()) {
    if (is_plain_[i] == 0 || std::isfinite(faces_.point[0][i] + faces_.point[1][i] + faces_.point[2][i])) continue;
    is_plain_[i] = 0;
    --plain;
    trace_alone(i, colors[ray_place_[i]]);
  }
  (depth_ == 0 ? report_.rays.primary : report_.rays.reflection) += counted + plain;
  return plain > 0;
}

// A ray that meets nothing.
void PacketTracer::leave(std::size_t ray, Rgb& color) const {
  const Rgb sky = view_.sky({direction_[0][ray], direction_[1][ray], direction_[2][ray]});
  color = depth_ == 0 ? sky : color + weight_[ray] * sky;
}

void PacketTracer::trace_alone(std::size_t ray, Rgb& color) {
  const Ray alone({origin_[0][ray], origin_[1][ray], origin_[2][ray]},
                  {direction_[0][ray], direction_[1][ray], direction_[2][ray]});
  if (depth_ == 0) {
    color = tracer_.trace(alone);
    return;
  }
  const Sense side = ray_departs_positive_[ray] != 0 ? Sense::positive : Sense::negative;
  color = tracer_.trace_on({alone, {SurfaceId(ray_departure_[ray]), side}, depth_, weight_[ray], color});
}

// Which plain rays' faces lead away.
void PacketTracer::look_outside() {
  const std::uint8_t* const sides = scene_.sides_that_lead_away().data();
  const std::uint8_t* const plain = is_plain_.data();
  const std::uint32_t* const surface = faces_.surface.data();
  const std::uint8_t* const comes_positive = faces_.comes_positive.data();
  std::uint8_t* const away = leads_away_.data();
  for (std::size_t i = 0, count = count_; i < count; ++i) {
    // No branch: the others may have no surface.
    const unsigned known = sides[plain[i] != 0 ? surface[i] : 0];
    away[i] = static_cast<std::uint8_t>(plain[i] & (known >> comes_positive[i]));
  }
}

// Adds what the plain rays' faces show by themselves.
void PacketTracer::shade(std::span<Rgb> colors) {
  const bool some_lead_away = !scene_.sides_that_lead_away().empty();
  if (some_lead_away) look_outside();
  const ShadingPoints points{count_,
                             is_plain_.data(),
                             {faces_.point[0].data(), faces_.point[1].data(), faces_.point[2].data()},
                             {faces_.normal[0].data(), faces_.normal[1].data(), faces_.normal[2].data()},
                             {direction_[0].data(), direction_[1].data(), direction_[2].data()},
                             faces_.look.data(),
                             some_lead_away ? leads_away_.data() : nullptr};
  code_.unlit(scene_.looks().data(), points, pointers(color_).data());
  for (const LightDescription& light : view_.lights) add_light(light, points);
  const auto [r, g, b] = pointers(color_);
  const std::uint8_t* const is_plain = is_plain_.data();
  const std::uint32_t* const place = ray_place_.data();
  const bool first = depth_ == 0;
  for (std::size_t i = 0; i < points.count; ++i) {
    if (is_plain[i] == 0) continue;
    const Rgb local{r[i], g[i], b[i]};
    Rgb& color = colors[place[i]];
    color = first ? local : color + weight_[i] * local;
  }
}

// The next depth's rays are those that the plain ones' faces reflect.
void PacketTracer::reflect(std::span<Rgb> colors) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    if (is_plain_[i] != 0 && scene_.looks()[faces_.look[i]].reflection > 0 && reflect(i, next, colors)) ++next;
  }
  count_ = next;
  if (depth_ + 1 < view_.settings.max_depth) return;
  ++depth_;
  for (std::size_t i = 0; i < count_; ++i) leave(i, colors[ray_place_[i]]);
  report_.skipped.depth_limit += count_;
  count_ = 0;
}

// Puts the ray that one's face reflects where it is told to, at or before its own place; false if it counts too little,
// or is done because it leads away.
bool PacketTracer::reflect(std::size_t ray, std::size_t to, std::span<Rgb> colors) {
  const Vector d{direction_[0][ray], direction_[1][ray], direction_[2][ray]};
  const Vector out{faces_.normal[0][ray], faces_.normal[1][ray], faces_.normal[2][ray]};
  const Vector direction = normalised(mirrored(d, dot(out, d) > 0 ? -out : out));
  const double share = scene_.looks()[faces_.look[ray]].reflection;
  const Rgb weight = share * (depth_ == 0 ? Rgb{1, 1, 1} : weight_[ray]);
  const bool is_direction = is_finite(direction) && direction != Vector{};
  if (brightest(weight) < view_.settings.min_contribution || !(brightest(weight) > 0) || !is_direction) {
    ++report_.skipped.reflection_below_cutoff;
    return false;
  }
  const bool is_last = depth_ + 1 == view_.settings.max_depth;
  if (!is_last && leads_away_[ray] != 0 && dot(out, direction) > clear_departure) {
    ++report_.skipped.reflection_leading_away;
    Rgb& color = colors[ray_place_[ray]];
    color = color + weight * view_.sky(direction);
    return false;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    origin_[axis][to] = faces_.point[axis][ray];
    direction_[axis][to] = direction[axis];
  }
  weight_[to] = weight;
  ray_place_[to] = ray_place_[ray];
  ray_departure_[to] = faces_.surface[ray];
  ray_departs_positive_[to] = faces_.comes_positive[ray];
  return true;
}

// Adds what a light brings where nothing is in its way.
void PacketTracer::add_light(const LightDescription& light, const ShadingPoints& points) {
  ShadowRays shadows;
  std::copy_n(pointers(shadow_origin_).begin(), 3, shadows.origin);
  std::copy_n(pointers(path_).begin(), 3, shadows.path);
  std::copy_n(pointers(light_).begin(), 3, shadows.light);
  shadows.sample = sample_.data();
  code_.light(scene_.looks().data(), light, points, shadows, pointers(color_).data());
  report_.skipped.shadow_facing_away += shadows.facing_away;
  report_.skipped.shadow_without_effect += shadows.without_effect;
  report_.skipped.shadow_leading_away += shadows.leading_away;
  report_.rays.shadow += shadows.count;
  if (shadows.count == 0) return;
  depart(shadows);
  RayArrays rays;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rays.origin[axis] = {shadows.origin[axis], shadows.count};
    rays.direction[axis] = {shadows.path[axis], shadows.count};
  }
  rays.departure = {departure_.data(), shadows.count};
  rays.departs_positive = {departs_positive_.data(), shadows.count};
  if (light.position) rays.end = {ones_.data(), shadows.count};
  caster_.any_hits(rays, blocked_);
  const auto [r, g, b] = pointers(color_);
  const std::uint8_t* const blocked = blocked_.data();
  for (std::size_t ray = 0; ray < shadows.count; ++ray) {
    if (blocked[ray] != 0) continue;
    const std::size_t sample = shadows.sample[ray];
    r[sample] += shadows.light[0][ray];
    g[sample] += shadows.light[1][ray];
    b[sample] += shadows.light[2][ray];
  }
}

// Shadow rays depart from the faces that their samples see.
void PacketTracer::depart(const ShadowRays& shadows) {
  const std::uint32_t* const surface = faces_.surface.data();
  const std::uint8_t* const comes_positive = faces_.comes_positive.data();
  std::uint32_t* const departure = departure_.data();
  std::uint8_t* const positive = departs_positive_.data();
  const std::uint32_t* const sample = shadows.sample;
  const std::size_t count = shadows.count;
  for (std::size_t ray = 0; ray < count; ++ray) departure[ray] = surface[sample[ray]];
  for (std::size_t ray = 0; ray < count; ++ray) positive[ray] = comes_positive[sample[ray]];
}

}  // namespace csgcast::detail
