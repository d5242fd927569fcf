// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/ray/detail/choice_search.h"
#include "raycast/ray/detail/local_tree.h"
#include "raycast/ray/hit.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// Tells where points are: inside, outside or on the boundary of a scene's nodes. Looks at the exact signs of the
/// surfaces near a point; those that are zero there may be on either side.
class PointLocator {
 public:
  /// The scene must outlive it.
  explicit PointLocator(const Scene& scene) : scene_(scene) {}

  /// Never falsely inside or outside. Throws Error(bad_value) for a point that is not finite.
  Location locate(NodeId node, Point p);
  /// The first part in file order that holds the point inside; not valid if there is none.
  PartId part_at(Point p);

 private:
  const Scene& scene_;
  LocalTree near_;
  ChoiceSearch search_;
};

}  // namespace csgcast::detail
