// SPDX-License-Identifier: MIT
#include "shade/detail/packet_sights.h"

#include <algorithm>
#include <cmath>

#include "shade/detail/shading_lanes.h"

namespace csgcast::detail {
namespace {

constexpr std::size_t at_once = 1024;
constexpr std::size_t more = 8;  // stores of whole registers reach beyond

}  // namespace

PacketSights::PacketSights(const Cells& cells, const Camera& camera, std::string_view instructions)
    : scene_(cells.scene()),
      camera_(camera),
      code_(shading_code(instructions)),
      caster_(cells, PacketCaster::Width::packet, instructions) {
  for (Vectors* vectors : {&origin_, &direction_, &point_, &normal_})
    for (Numbers& numbers : *vectors) numbers.resize(at_once + more);
  t_.resize(at_once + more);
  for (auto* list : {&surface_, &look_, &leaf_}) list->resize(at_once);
  for (auto* list : {&state_, &comes_positive_}) list->resize(at_once);
}

// Those of the samples from `first` on, as many as are traced at once.
RayArrays PacketSights::rays_of(const Samples& samples, std::size_t first) {
  RayArrays rays;
  rays.count = std::min(at_once, samples.x.size() - first);
  double* origin[3];
  double* direction[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rays.origin[axis] = origin[axis] = origin_[axis].data();
    rays.direction[axis] = direction[axis] = direction_[axis].data();
  }
  code_.camera_rays(camera_.frame(), rays.count, samples.x.data() + first, samples.y.data() + first, origin, direction);
  primary_ += rays.count;
  return rays;
}

void PacketSights::look(const Samples& samples, std::span<Sight> sights) {
  FaceArrays faces;
  faces.state = state_.data();
  faces.t = t_.data();
  faces.surface = surface_.data();
  faces.look = look_.data();
  faces.comes_positive = comes_positive_.data();
  faces.leaf = leaf_.data();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    faces.point[axis] = point_[axis].data();
    faces.normal[axis] = normal_[axis].data();
  }
  for (std::size_t first = 0; first < samples.x.size(); first += at_once) {
    const RayArrays rays = rays_of(samples, first);
    caster_.first_faces(rays, faces);
    for (std::size_t i = 0; i < rays.count; ++i) sights[samples.place[first + i]] = sight(i);
  }
}

Sight PacketSights::sight(std::size_t i) const {
  if (state_[i] == FaceArrays::none) return {};
  const Vector out{normal_[0][i], normal_[1][i], normal_[2][i]};
  const Vector direction{direction_[0][i], direction_[1][i], direction_[2][i]};
  const LeafId leaf(leaf_[i]);
  return sight_of(t_[i], {point_[0][i], point_[1][i], point_[2][i]}, out, direction, SurfaceId(surface_[i]), leaf,
                  scene_.leaf(leaf).part, LookId(look_[i]));
}

void PacketSights::measure(const Samples& samples, std::span<double> lengths) {
  for (std::size_t first = 0; first < samples.x.size(); first += at_once) {
    const RayArrays rays = rays_of(samples, first);
    caster_.intervals(rays, intervals_);
    for (std::size_t i = 0; i < rays.count; ++i) lengths[samples.place[first + i]] = total_length(intervals_.of(i));
  }
}

RenderReport PacketSights::report() const {
  RenderReport report;
  report.rays.primary = primary_;
  report.casts = caster_.caster_counts();
  report.packets = caster_.counts();
  return report;
}

}  // namespace csgcast::detail
