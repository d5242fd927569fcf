// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "csg/vector.h"

namespace csgcast {

class ExactAffine;
class Solid;
struct LeafShape;

/// A closed axis-aligned box; null (lower > upper) holds no point, a degenerate one (lower == upper) still holds some.
struct Box {
  Point lower{inf, inf, inf};
  Point upper{-inf, -inf, -inf};

  static constexpr Box everything() { return {{-inf, -inf, -inf}, {inf, inf, inf}}; }

  bool is_null() const { return lower.x > upper.x || lower.y > upper.y || lower.z > upper.z; }
  bool is_finite() const;  ///< not null, and no side is infinite
  bool contains(Point p) const;
  Vector size() const { return upper - lower; }
  Point center() const;
  friend bool operator==(const Box&, const Box&) = default;

 private:
  static constexpr double inf = std::numeric_limits<double>::infinity();
};

/// The least box that holds both.
Box hull(const Box& a, const Box& b);
/// The points in both; touching boxes share a degenerate one.
Box intersection(const Box& a, const Box& b);

/// A box that holds the image of every point of a box, rounded outward: the exact extents of its corners, infinite
/// along the axes that an infinite side reaches.
Box image(const Box& box, const ExactAffine& world_from_solid);

/// A box that holds the moved leaf, rounded outward: the exact extents of polyhedra given by points, boxes, balls,
/// ellipsoids, cylinders, cones, and of quadrics that are bounded along an axis; else the image of the leaf's own box.
/// Precondition: world_from_solid is not singular.
Box world_bounds(const LeafShape& shape, const ExactAffine& world_from_solid);

/// A box that holds every point of the closed solid, rounded outward: tight for leaves, what the boxes of the children
/// give for operators. Infinite sides where the solid may be unbounded, null where it is known to be empty.
Box bounds(const Solid& solid);

}  // namespace csgcast
