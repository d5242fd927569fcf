// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/ray/detail/choice_search.h"
#include "raycast/ray/detail/local_tree.h"
#include "raycast/ray/hit.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// Tells where points are: inside, outside or on the boundary of a scene's nodes. It uses the exact signs of the
/// surfaces near a point. Where a sign is zero, both sides are considered.
class PointLocator {
 public:
  /// The scene must outlive it.
  explicit PointLocator(const Scene& scene) : scene_(scene) {}

  /// The answer is never falsely inside or outside. Throws Error(bad_value) for a point that is not finite.
  Location locate(NodeId node, Point p);
  /// The first part in file order that has the point inside. It is not valid if there is none.
  PartId part_at(Point p);

 private:
  const Scene& scene_;
  LocalTree near_;
  ChoiceSearch search_;
};

}  // namespace csgcast::detail
