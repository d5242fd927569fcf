// SPDX-License-Identifier: MIT
#include "raycast/ray/detail/point_locator.h"

#include <span>

#include "csg/base/length.h"
#include "raycast/surface/predicates.h"

namespace csgcast::detail {

Location PointLocator::locate(NodeId node, Point p) {
  if (!is_finite(p)) {
    throw Error(ErrorCode::bad_value, {}, "a point needs three finite numbers",
                "no other place can be inside or outside", "check its coordinates");
  }
  near_.build(scene_, node, [&](const Box& box) { return box.contains(p); });
  search_.clear();
  for (std::uint32_t slot = 0; slot < near_.leaves().size(); ++slot) {
    const Leaf& leaf = scene_.leaf(near_.leaves()[slot]);
    for (const HalfSpace& half_space : scene_.half_spaces(leaf))
      search_.add(slot, half_space, sign_at(scene_.surface(half_space.surface), p));
    if (leaf.function != nullptr) search_.set_function(slot, *leaf.function, leaf.count);
  }
  return search_.run(near_);
}

PartId PointLocator::part_at(Point p) {
  const std::span<const Part> parts = scene_.parts();
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    if (locate(parts[i].node, p) == Location::inside) return PartId(i);
  }
  return {};
}

}  // namespace csgcast::detail
