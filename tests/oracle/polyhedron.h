// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "raycast/ray/hit.h"
#include "tests/oracle/rational.h"

namespace csgcast::oracle {

/// A convex polyhedron as CGAL sees it, by exact kernels: the half-spaces that bound it, and if it is bounded its
/// triangulated surface.
class Polyhedron {
 public:
  using Triangle = std::array<std::size_t, 3>;

  /// CGAL::convex_hull_3; none if all points lie in one plane.
  static std::optional<Polyhedron> hull(const std::vector<RationalPoint>& points);
  /// CGAL::halfspace_intersection_3 about a point strictly inside; the intersection must be bounded. Redundant
  /// half-spaces are kept.
  static Polyhedron intersection(const std::vector<RationalPlane>& planes, const RationalPoint& inside);
  /// The half-spaces alone, without a surface: maybe unbounded or empty.
  static Polyhedron half_spaces(const std::vector<RationalPlane>& planes);

  /// Primitive, sorted, each once; the polyhedron is where all are <= 0.
  const std::vector<RationalPlane>& planes() const;
  /// Of the surface; empty if there is none.
  const std::vector<RationalPoint>& corners() const;
  /// Counter-clockwise seen from outside, indices into the corners.
  const std::vector<Triangle>& triangles() const;

  /// CGAL::Side_of_triangle_mesh; none without a surface.
  std::optional<Location> side_of_mesh(Point p) const;
  /// The signs of all planes at a point, by CGAL::Plane_3::oriented_side. The vector is overwritten.
  void signs(Point p, std::vector<int>& signs) const;

 private:
  struct Data;
  explicit Polyhedron(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;
};

}  // namespace csgcast::oracle
