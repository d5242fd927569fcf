// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "csg/exact/hull.h"
#include "csg/solid/detail/leaf_forms.h"
#include "csg/solid/detail/polyhedron_bounds.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/primitives.h"

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

// How far the coordinates of points may be off.
class PointErrors {
 public:
  PointErrors(std::span<const Point> points, Digits digits) : digits_(digits) {
    has_longest_ = digits.are_few() && std::any_of(points.begin(), points.end(), [digits](Point p) {
                     return digits.uses_all(p.x) || digits.uses_all(p.y) || digits.uses_all(p.z);
                   });
  }

  Vector of(Point p) const { return {of(p.x), of(p.y), of(p.z)}; }

 private:
  double of(double coordinate) const {
    return has_longest_ ? digits_.error_beside_longer(coordinate) : digits_.error(coordinate);
  }

  Digits digits_;
  bool has_longest_ = false;
};

// The distance that the plane moves, about `center`, by the errors of its points. Plain double is enough, because an
// error's own error does not matter.
FormError plane_error(Point a, Point b, Point c, Point center, const PointErrors& errors) {
  const Vector v = b - a, w = c - a;
  const auto magnitudes = [](auto p) { return Vector{std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}; };
  const Vector off_a = errors.of(a);
  const Vector off_v = off_a + errors.of(b);
  const Vector off_w = off_a + errors.of(c);
  const Vector n = magnitudes(cross(v, w)), from_a = magnitudes(center - a);
  const Vector size_v = magnitudes(v), size_w = magnitudes(w);
  FormError error{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double off = off_v[i] * size_w[j] + size_v[i] * off_w[j] + off_v[j] * size_w[i] + size_v[j] * off_w[i];
    error[QuadricForm::x + k] = off;
    error[QuadricForm::one] += off * from_a[k] + n[k] * off_a[k];
  }
  return error;
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

Solid convex_from_planes(std::span<const PlaneEquation> planes, Digits digits) {
  std::vector<detail::FormWithError> forms;
  for (const auto& [normal, distance] : planes) {
    detail::require_finite("convex", {normal.x, normal.y, normal.z, distance});
    const QuadricForm form = detail::plane_form("convex", normal, distance);
    forms.push_back({form, detail::coefficient_error(form, digits)});
  }
  if (forms.empty()) return Solid::everything();
  LeafShape shape;
  shape.kind = LeafKind::convex;
  shape.error.digits = digits;
  detail::set_forms(shape, forms);
  shape.bounds = detail::polyhedron_bounds(std::vector<QuadricForm>(shape.forms.begin(), shape.forms.end()));
  if (shape.bounds.is_null()) return {};
  shape.is_convex_polyhedron = true;
  return Solid::leaf(std::move(shape));
}

namespace {

std::optional<LeafShape> hull_shape(std::span<const Point> points, Digits digits) {
  for (const Point& p : points) detail::require_finite("convex", {p.x, p.y, p.z});
  const std::vector<HullTriangle> triangles = convex_hull(points);
  if (triangles.empty()) return std::nullopt;
  const PointErrors errors(points, digits);
  LeafShape shape;
  shape.kind = LeafKind::convex;
  shape.error.digits = digits;
  shape.vertices = corners_used(points, triangles);
  shape.bounds = box_of(shape.vertices);
  shape.error.center = shape.bounds.center();
  std::vector<detail::FormWithError> forms;
  forms.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    forms.push_back({plane_through(points[a], points[b], points[c]),
                     plane_error(points[a], points[b], points[c], shape.error.center, errors)});
  }
  detail::set_forms(shape, forms);
  shape.is_convex_polyhedron = true;
  return shape;
}

}  // namespace

Solid convex_from_points(std::span<const Point> points, Digits digits) {
  std::optional<LeafShape> shape = hull_shape(points, digits);
  return shape ? Solid::leaf(std::move(*shape)) : Solid();
}

Solid convex_from_points(std::span<const Point> points, Vector axes) {
  std::optional<LeafShape> shape = hull_shape(points, {});
  if (!shape) return {};
  shape->error.axes = axes;
  return Solid::leaf(std::move(*shape));
}

}  // namespace csgcast
