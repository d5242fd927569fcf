// SPDX-License-Identifier: MIT
#include "shade/trace/detail/packet_sights.h"

#include <algorithm>
#include <cmath>

#include "csg/base/precondition.h"
#include "shade/trace/detail/shading_lanes.h"

namespace csgcast::detail {
namespace {

constexpr std::size_t at_once = 1024;

}  // namespace

PacketSights::PacketSights(const Cells& cells, const Camera& camera, std::string_view instructions)
    : scene_(cells.scene()),
      camera_(camera),
      code_(shading_code(instructions)),
      caster_(cells, PacketCaster::Width::packet, instructions) {
  CSGCAST_PRECONDITION(camera.rays_are_in_range());
  for (Vectors* vectors : {&origin_, &direction_})
    for (Numbers& numbers : *vectors) numbers.resize(at_once + FaceBuffers::more);
  faces_.resize(at_once);
  leaf_.resize(at_once);
}

// Those of the samples from `first` on, as many as are traced at once.
RayArrays PacketSights::rays_of(const Samples& samples, std::size_t first) {
  RayArrays rays;
  const std::size_t count = std::min(at_once, samples.x.size() - first);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rays.origin[axis] = {origin_[axis].data(), count};
    rays.direction[axis] = {direction_[axis].data(), count};
  }
  code_.camera_rays(camera_.frame(), count, samples.x.data() + first, samples.y.data() + first,
                    pointers(origin_).data(), pointers(direction_).data());
  primary_ += count;
  return rays;
}

void PacketSights::look(const Samples& samples, std::span<Sight> sights) {
  FaceArrays faces = faces_.arrays();
  faces.leaf = leaf_;
  for (std::size_t first = 0; first < samples.x.size(); first += at_once) {
    const RayArrays rays = rays_of(samples, first);
    caster_.first_faces(rays, faces);
    for (std::size_t i = 0; i < rays.count(); ++i) sights[samples.place[first + i]] = sight(i);
  }
}

Sight PacketSights::sight(std::size_t i) const {
  if (faces_.state[i] == FaceArrays::none) return {};
  const Vector out{faces_.normal[0][i], faces_.normal[1][i], faces_.normal[2][i]};
  const Vector direction{direction_[0][i], direction_[1][i], direction_[2][i]};
  const LeafId leaf(leaf_[i]);
  return sight_of(faces_.t[i], {faces_.point[0][i], faces_.point[1][i], faces_.point[2][i]}, out, direction,
                  SurfaceId(faces_.surface[i]), leaf, scene_.leaf(leaf).part, LookId(faces_.look[i]));
}

void PacketSights::measure(const Samples& samples, std::span<double> lengths) {
  for (std::size_t first = 0; first < samples.x.size(); first += at_once) {
    const RayArrays rays = rays_of(samples, first);
    caster_.intervals(rays, intervals_);
    for (std::size_t i = 0; i < rays.count(); ++i) lengths[samples.place[first + i]] = total_length(intervals_.of(i));
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
