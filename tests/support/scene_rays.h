// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "raycast/line/ray.h"
#include "raycast/scene/scene.h"
#include "tests/support/random_solid.h"

namespace csgcast::test {

/// Rays that meet a scene anywhere, and rays that meet it where it is hardest, in turn: in its axis-parallel faces,
/// along and through their edges, through their corners. The same seed gives the same rays.
class SceneRays {
 public:
  /// The scene is looked at only here.
  SceneRays(const Scene& scene, std::uint64_t seed);

  /// A ray of any of these kinds.
  Ray next();
  /// From outside the box of the bounded leaves through it.
  Ray through_anywhere();
  /// The same, along an axis.
  Ray along_an_axis();
  /// In two of the axis-parallel planes: along an edge, or where it would go on.
  Ray along_an_edge();
  /// In one axis-parallel plane, and in no other on purpose.
  Ray in_a_face();
  /// Through a corner of the grid in a direction of small whole numbers.
  Ray through_a_corner();
  /// From one corner of the grid to another.
  Ray between_corners();

  /// A point in the box, or a little beside it.
  Point anywhere();
  /// A point where three of the axis-parallel planes meet; where there are none of an axis, any coordinate.
  Point corner();

 private:
  double coordinate(std::size_t axis);

  Box box_;
  double size_;                                ///< of the box: its diagonal
  std::array<std::vector<double>, 3> planes_;  ///< where the axis-parallel planes of each axis are
  RandomSolids random_;
};

}  // namespace csgcast::test
