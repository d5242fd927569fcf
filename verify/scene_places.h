// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "raycast/ray/caster.h"
#include "verify/random.h"

namespace csgcast::verify {

/// A point on a surface, up to a few ulps.
struct SurfacePlace {
  SurfaceId surface;
  Point point;
  Vector normal;  ///< unit; zero at an apex
};

/// A point where two or three surfaces meet, up to a few ulps.
struct Corner {
  Point point;
  Vector
      along;  ///< the edge's direction, of any length, zero where it has none; of three surfaces that of the first two
};

/// Finds places of a scene where rays are hard. The scene may be bounded or not, of any size, or empty. The result is
/// nullopt if the place does not exist, or is not found after some tries. Working memory for one thread. The results
/// depend only on the scene and the random source.
class ScenePlaces {
 public:
  enum class Shape { flat, curved };  ///< of a surface: a plane, or not

  /// The scene must outlive it.
  explicit ScenePlaces(const Scene& scene);

  const Scene& scene() const { return caster_.scene(); }
  Caster& caster() { return caster_; }
  /// The approximate size of all bounded leaves together, as a power of two. 1 if there are none.
  double size() const { return size_; }

  /// A point among the bounded leaves, often near one of them.
  Point anywhere(Random& random) const;
  /// A point on a surface, on the boundary of the solid or not. If `shape` is given, only such surfaces are used.
  std::optional<SurfacePlace> on_surface(Random& random, std::optional<Shape> shape = std::nullopt);
  /// A point where `count` surfaces (2 or 3) meet. They belong to one leaf, or to leaves that one ray meets.
  std::optional<Corner> corner(Random& random, std::size_t count);
  /// The apex of a cone or the center of another quadric.
  std::optional<Point> center(Random& random);

 private:
  bool has(Shape shape) const { return shape == Shape::flat ? has_flat_ : has_curved_; }
  const Leaf* some_leaf(Random& random, Box* box) const;
  std::optional<SurfaceId> some_surface(Random& random) const;
  std::optional<SurfacePlace> hit(Random& random);
  std::size_t pick_surfaces(Random& random, std::size_t count, SurfaceId* picked, Point& start);

  Caster caster_;
  IntervalList list_;
  Box region_;
  double size_;
  bool has_flat_ = false;
  bool has_curved_ = false;
};

}  // namespace csgcast::verify
