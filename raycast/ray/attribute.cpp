// SPDX-License-Identifier: MIT
#include "csg/base/length.h"
#include "raycast/ray/caster.h"
#include "raycast/ray/detail/caster_state.h"

// Where a hit belongs: leaf, region, part, look, normal.

namespace csgcast {
namespace {

// Out of the solid: towards the side of the surface that the ray is on where it is outside.
Normal outward_normal(const Surface& surface, const Frame& frame, Point place, const Ray& ray, const Hit& hit,
                      bool outside_is_positive) {
  const Vector slope = normalised(gradient(surface, frame, place));
  // At an apex every direction is square to the surface; the ray's own is the one that is seen.
  if (slope == Vector{}) {
    const Vector d = normalised(ray.direction());
    return as_normal(hit.passage == Passage::entry ? -d : d);
  }
  return as_normal(outside_is_positive ? slope : -slope);
}

}  // namespace

Attribution Caster::attribute(NodeId node, const Hit& hit) {
  State& state = *state_;
  const Scene& scene = state.scene;
  const LineCrossings& found = state.cache.found(hit.crossing.surface);
  const bool positive_before = found.positive_after(hit.crossing.root);
  const bool outside_is_positive = hit.passage == Passage::entry ? positive_before : !positive_before;

  state.neighbourhood.move_to(node, hit.crossing);
  Attribution result;
  result.leaf = state.neighbourhood.bounding_leaf();
  if (!result.leaf.valid()) {
    throw Error(ErrorCode::usage, {}, "a hit was asked about that is not on this ray or solid",
                "no face of it is there", "ask with the ray and node that gave the hit");
  }
  const Leaf& leaf = scene.leaf(result.leaf);
  result.region = leaf.region;
  result.part = leaf.part;
  result.look = leaf.look;
  result.front = positive_before ? Sense::positive : Sense::negative;
  result.point = state.cache.point(hit.crossing);
  result.normal = outward_normal(scene.surface(hit.crossing.surface), scene.frame(), result.point, state.cache.ray(),
                                 hit, outside_is_positive);
  if (leaf.shows_cut) {
    const LeafId holder = state.neighbourhood.holding_leaf(hit.passage);
    result.look = holder.valid() ? scene.leaf(holder).look : scene.region(leaf.region).look;
  }
  return result;
}

LookId Caster::look_inside(NodeId node, const Hit& hit) {
  State& state = *state_;
  state.neighbourhood.move_to(node, hit.crossing);
  const LeafId holder = state.neighbourhood.holding_leaf(hit.passage);
  return holder.valid() ? state.scene.leaf(holder).look : LookId();
}

}  // namespace csgcast
