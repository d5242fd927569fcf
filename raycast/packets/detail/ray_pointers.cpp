// SPDX-License-Identifier: MIT
#include "raycast/packets/detail/ray_pointers.h"

#include "csg/base/precondition.h"

namespace csgcast::detail {
namespace {

template <class T>
T* pointer_of(std::span<T> array) {
  return array.empty() ? nullptr : array.data();
}

}  // namespace

RayPointers pointers_of(const RayArrays& rays) {
  RayPointers pointers;
  pointers.count = rays.count();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    CSGCAST_PRECONDITION(rays.origin[axis].size() == rays.count());
    CSGCAST_PRECONDITION(rays.direction[axis].size() == rays.count());
    pointers.origin[axis] = pointer_of(rays.origin[axis]);
    pointers.direction[axis] = pointer_of(rays.direction[axis]);
  }
  CSGCAST_PRECONDITION(rays.departure.empty() || rays.departure.size() == rays.count());
  CSGCAST_PRECONDITION(rays.departs_positive.size() == rays.departure.size());
  CSGCAST_PRECONDITION(rays.departure.empty() || !rays.whole_line);
  CSGCAST_PRECONDITION(rays.end.empty() || rays.end.size() == rays.count());
  pointers.departure = pointer_of(rays.departure);
  pointers.departs_positive = pointer_of(rays.departs_positive);
  pointers.whole_line = rays.whole_line;
  pointers.end = pointer_of(rays.end);
  return pointers;
}

HitPointers pointers_of(const HitArrays& hits, std::size_t rays, bool rounds) {
  CSGCAST_PRECONDITION(hits.state.size() >= rays);
  CSGCAST_PRECONDITION(hits.t.size() >= rays);
  CSGCAST_PRECONDITION(hits.surface.size() >= rays);
  CSGCAST_PRECONDITION(hits.root.size() >= rays || (hits.root.empty() && !rounds));
  CSGCAST_PRECONDITION(hits.is_inside.size() >= rays || hits.is_inside.empty());
  return {pointer_of(hits.state), pointer_of(hits.t), pointer_of(hits.surface), pointer_of(hits.root),
          pointer_of(hits.is_inside)};
}

FacePointers pointers_of(const FaceArrays& faces, std::size_t rays) {
  FacePointers pointers;
  static_cast<HitPointers&>(pointers) = pointers_of(static_cast<const HitArrays&>(faces), rays, false);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    CSGCAST_PRECONDITION(faces.point[axis].size() >= rays);
    CSGCAST_PRECONDITION(faces.normal[axis].size() >= rays);
    pointers.point[axis] = pointer_of(faces.point[axis]);
    pointers.normal[axis] = pointer_of(faces.normal[axis]);
  }
  CSGCAST_PRECONDITION(faces.look.size() >= rays);
  CSGCAST_PRECONDITION(faces.comes_positive.size() >= rays);
  CSGCAST_PRECONDITION(faces.leaf.size() >= rays || faces.leaf.empty());
  pointers.look = pointer_of(faces.look);
  pointers.comes_positive = pointer_of(faces.comes_positive);
  pointers.leaf = pointer_of(faces.leaf);
  return pointers;
}

}  // namespace csgcast::detail
