// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <vector>

#include "csg/detail/leaf_forms.h"
#include "csg/detail/polyhedron_bounds.h"
#include "csg/hull.h"
#include "csg/primitives.h"

namespace csgcast {
namespace {

// The plane through three points; <= 0 on the side from which they are clockwise.
QuadricForm plane_through(Point a, Point b, Point c) {
  const auto difference = [a](Point p) {
    return ExactPoint{Dyadic(p.x) - Dyadic(a.x), Dyadic(p.y) - Dyadic(a.y), Dyadic(p.z) - Dyadic(a.z)};
  };
  const ExactPoint u = difference(b), v = difference(c);
  const ExactPoint n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  return QuadricForm::plane(n[0], n[1], n[2], -(n[0] * Dyadic(a.x) + n[1] * Dyadic(a.y) + n[2] * Dyadic(a.z)));
}

std::vector<Point> corners_used(std::span<const Point> points, std::span<const HullTriangle> triangles) {
  std::vector<bool> is_used(points.size());
  for (const HullTriangle& triangle : triangles) {
    for (const std::uint32_t corner : triangle) is_used[corner] = true;
  }
  std::vector<Point> corners;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_used[i]) corners.push_back(points[i]);
  }
  return corners;
}

Box box_of(std::span<const Point> points) {
  Box box;
  for (const Point& p : points) box = hull(box, Box{p, p});
  return box;
}

}  // namespace

Solid convex_from_planes(std::span<const PlaneEquation> planes) {
  std::vector<QuadricForm> forms;
  for (const auto& [normal, distance] : planes) {
    detail::require_finite("convex", {normal.x, normal.y, normal.z, distance});
    forms.push_back(detail::plane_form("convex", normal, distance));
  }
  if (forms.empty()) return Solid::everything();
  LeafShape shape;
  shape.kind = "convex";
  shape.forms = detail::without_duplicates(forms);
  shape.bounds = detail::polyhedron_bounds(shape.forms);
  if (shape.bounds.is_null()) return {};
  shape.is_convex_polyhedron = true;
  return Solid::leaf(std::move(shape));
}

Solid convex_from_points(std::span<const Point> points) {
  for (const Point& p : points) detail::require_finite("convex", {p.x, p.y, p.z});
  const std::vector<HullTriangle> triangles = convex_hull(points);
  if (triangles.empty()) return {};
  std::vector<QuadricForm> forms;
  forms.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) forms.push_back(plane_through(points[a], points[b], points[c]));
  LeafShape shape;
  shape.kind = "convex";
  shape.forms = detail::without_duplicates(forms);
  shape.vertices = corners_used(points, triangles);
  shape.bounds = box_of(shape.vertices);
  shape.is_convex_polyhedron = true;
  return Solid::leaf(std::move(shape));
}

}  // namespace csgcast
