// SPDX-License-Identifier: MIT
#include "raycast/ray/detail/attributor.h"

#include "csg/base/length.h"

namespace csgcast::detail {
namespace {

// The normal points out of the solid: to the side of the surface on which the ray is while it is outside.
Normal outward_normal(const Surface& surface, const Frame& frame, Point place, const Ray& ray, const Hit& hit,
                      bool outside_is_positive) {
  const Vector slope = normalised(gradient(surface, frame, place));
  // At an apex every direction is square to the surface. The ray's own direction is used, because a viewer sees that
  // one.
  if (slope == Vector{}) {
    const Vector d = normalised(ray.direction());
    return as_normal(hit.passage == Passage::entry ? -d : d);
  }
  return as_normal(outside_is_positive ? slope : -slope);
}

}  // namespace

Attribution Attributor::attribute(NodeId node, const Hit& hit) {
  const LineCrossings& found = cache_.found(hit.crossing.surface);
  const bool positive_before = found.positive_after(hit.crossing.root);
  const bool outside_is_positive = hit.passage == Passage::entry ? positive_before : !positive_before;

  neighbourhood_.move_to(node, hit.crossing);
  Attribution result;
  result.leaf = neighbourhood_.bounding_leaf();
  if (!result.leaf.valid()) {
    throw Error(ErrorCode::usage, {}, "a hit was asked about that is not on this ray or solid",
                "no face of it is there", "ask with the ray and node that gave the hit");
  }
  const Leaf& leaf = scene_.leaf(result.leaf);
  result.region = leaf.region;
  result.part = leaf.part;
  result.look = leaf.look;
  result.front = positive_before ? Sense::positive : Sense::negative;
  result.point = cache_.point(hit.crossing);
  result.normal = outward_normal(scene_.surface(hit.crossing.surface), scene_.frame(), result.point, cache_.ray(), hit,
                                 outside_is_positive);
  if (leaf.shows_cut) {
    const LeafId holder = neighbourhood_.holding_leaf(hit.passage);
    result.look = holder.valid() ? scene_.leaf(holder).look : scene_.region(leaf.region).look;
  }
  return result;
}

LookId Attributor::look_inside(NodeId node, const Hit& hit) {
  neighbourhood_.move_to(node, hit.crossing);
  const LeafId holder = neighbourhood_.holding_leaf(hit.passage);
  return holder.valid() ? scene_.leaf(holder).look : LookId();
}

}  // namespace csgcast::detail
