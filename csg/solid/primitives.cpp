// SPDX-License-Identifier: MIT
#include "csg/solid/primitives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string>

#include "csg/solid/detail/leaf_forms.h"
#include "csg/solid/leaf_shape.h"

namespace csgcast {
namespace {

using detail::require_finite;
using enum QuadricForm::Term;

Dyadic square(const Dyadic& a) { return a * a; }
Dyadic twice(const Dyadic& a) { return a.scaled(1); }
Dyadic half(const Dyadic& a) { return a.scaled(-1); }

// xx x² + yy y² + zz z² + z z + one.
QuadricForm axial_form(Dyadic cxx, Dyadic cyy, Dyadic czz, Dyadic cz, Dyadic cone) {
  QuadricForm f;
  f.coefficient[xx] = std::move(cxx);
  f.coefficient[yy] = std::move(cyy);
  f.coefficient[zz] = std::move(czz);
  f.coefficient[z] = std::move(cz);
  f.coefficient[one] = std::move(cone);
  return f;
}

// An exact closed range of one coordinate.
struct Range {
  Dyadic lower;
  Dyadic upper;
};

Range extent(double size, Centering centering) {
  if (centering == Centering::corner) return {Dyadic(), size};
  return {-half(size), half(size)};
}

// lower <= coordinate <= upper, as two planes.
void append_slab(FormList& forms, std::size_t axis, const Range& range) {
  std::array<Dyadic, 3> n;
  n[axis] = Dyadic(-1.0);
  forms.push_back(QuadricForm::plane(n[0], n[1], n[2], range.lower));
  n[axis] = Dyadic(1.0);
  forms.push_back(QuadricForm::plane(n[0], n[1], n[2], -range.upper));
}

std::vector<Point> corners_of(const Box& b) {
  std::vector<Point> corners;
  corners.reserve(8);
  for (const double cz : {b.lower.z, b.upper.z}) {
    for (const double cy : {b.lower.y, b.upper.y}) {
      for (const double cx : {b.lower.x, b.upper.x}) corners.push_back({cx, cy, cz});
    }
  }
  return corners;
}

/// Of a leaf that sizes scale, one on each axis. Those of a list stand beside each other.
ShapeError size_error(Vector sizes, Digits digits, bool are_list = false) {
  ShapeError error;
  error.digits = digits;
  if (!digits.are_few()) return error;
  const bool has_longest = are_list && digits.uses_all(std::array{sizes.x, sizes.y, sizes.z});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double size = sizes[axis];
    error.axes[axis] = (has_longest ? digits.error_beside_longer(size) : digits.error(size)) / size;
  }
  return error;
}

Box box_about_axis(double radius, const Range& range) {
  return {{-radius, -radius, range.lower.rounded_down()}, {radius, radius, range.upper.rounded_up()}};
}

}  // namespace

Solid box(Vector size, Centering centering, Digits digits) {
  require_finite("cube", {size.x, size.y, size.z});
  if (!(size.x > 0 && size.y > 0 && size.z > 0)) return {};
  LeafShape shape;
  shape.kind = LeafKind::cube;
  shape.error = size_error(size, digits, true);
  shape.is_convex_polyhedron = true;
  shape.forms.reserve(6);
  bool exact = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Range range = extent(size[axis], centering);
    append_slab(shape.forms, axis, range);
    shape.bounds.lower[axis] = range.lower.rounded_down();
    shape.bounds.upper[axis] = range.upper.rounded_up();
    exact = exact && Dyadic(shape.bounds.upper[axis]) == range.upper;
  }
  if (exact) shape.vertices = corners_of(shape.bounds);
  return Solid::leaf(std::move(shape));
}

Solid sphere(double radius, Digits digits) {
  require_finite("sphere", {radius});
  if (!(radius > 0)) return {};
  LeafShape shape;
  shape.kind = LeafKind::sphere;
  shape.error = size_error({radius, radius, radius}, digits);
  shape.forms.push_back(axial_form(1.0, 1.0, 1.0, {}, -square(radius)));
  shape.bounds = {{-radius, -radius, -radius}, {radius, radius, radius}};
  shape.semi_axes = Vector{radius, radius, radius};
  return Solid::leaf(std::move(shape));
}

Solid ellipsoid(Vector semi_axes, Digits digits) {
  require_finite("ellipsoid", {semi_axes.x, semi_axes.y, semi_axes.z});
  if (!(semi_axes.x > 0 && semi_axes.y > 0 && semi_axes.z > 0)) return {};
  const Dyadic a2 = square(semi_axes.x), b2 = square(semi_axes.y), c2 = square(semi_axes.z);
  LeafShape shape;
  shape.kind = LeafKind::ellipsoid;
  shape.error = size_error(semi_axes, digits, true);
  shape.forms.push_back(axial_form(b2 * c2, a2 * c2, a2 * b2, {}, -(a2 * b2 * c2)));
  shape.bounds = {{-semi_axes.x, -semi_axes.y, -semi_axes.z}, {semi_axes.x, semi_axes.y, semi_axes.z}};
  shape.semi_axes = semi_axes;
  return Solid::leaf(std::move(shape));
}

Solid cylinder(double height, double bottom_radius, double top_radius, Centering centering, Digits digits) {
  require_finite("cylinder", {height, bottom_radius, top_radius});
  const double widest = std::max(bottom_radius, top_radius);
  if (!(height > 0 && bottom_radius >= 0 && top_radius >= 0 && widest > 0)) return {};
  const Range range = extent(height, centering);
  LeafShape shape;
  shape.kind = LeafKind::cylinder;
  shape.error = size_error({widest, widest, height}, digits);
  if (bottom_radius == top_radius) {
    // The form does not depend on z or on the height, so cylinders that differ only in these share the surface.
    shape.forms.push_back(axial_form(1.0, 1.0, {}, {}, -square(bottom_radius)));
  } else {
    // The radius at z is (base + slope z) / height.
    const Dyadic slope = Dyadic(top_radius) - Dyadic(bottom_radius);
    const Dyadic base = Dyadic(height) * Dyadic(bottom_radius) - slope * range.lower;
    const Dyadic h2 = square(height);
    shape.forms.push_back(axial_form(h2, h2, -square(slope), -twice(base * slope), -square(base)));
  }
  append_slab(shape.forms, 2, range);
  if (bottom_radius != top_radius) {
    // (base + slope z)² with base + slope z off by height times the error of each radius.
    const double s = std::fabs(top_radius - bottom_radius), b = height * widest;
    const double off = height * (digits.error(bottom_radius) + digits.error(top_radius));
    shape.error.errors.resize(shape.forms.size());
    shape.error.errors.front()[z] = 2 * off * s;
    shape.error.errors.front()[one] = 2 * off * b;
  }
  shape.bounds = box_about_axis(widest, range);
  shape.discs = {{shape.bounds.lower.z, bottom_radius}, {shape.bounds.upper.z, top_radius}};
  return Solid::leaf(std::move(shape));
}

Solid paraboloid(double height, double radius, Digits digits) {
  require_finite("paraboloid", {height, radius});
  if (!(height > 0 && radius > 0)) return {};
  const Range range = extent(height, Centering::corner);
  LeafShape shape;
  shape.kind = LeafKind::paraboloid;
  shape.error = size_error({radius, radius, height}, digits);
  shape.forms.push_back(axial_form(height, height, {}, -square(radius), {}));
  shape.forms.push_back(QuadricForm::plane({}, {}, 1.0, -Dyadic(height)));
  shape.bounds = box_about_axis(radius, range);
  // The cone that touches the paraboloid at its rim: radius sqrt(z/height) <= radius (1 + z/height) / 2.
  shape.discs = {{0, half(radius).rounded_up()}, {height, radius}};
  return Solid::leaf(std::move(shape));
}

Solid hyperboloid(double height, double radius, double waist, Digits digits) {
  require_finite("hyperboloid", {height, radius, waist});
  const double widest = std::max(radius, waist);
  if (!(height > 0 && radius >= 0 && waist >= 0 && widest > 0)) return {};
  const Range range = extent(height, Centering::centered);
  LeafShape shape;
  shape.kind = LeafKind::hyperboloid;
  shape.error = size_error({widest, widest, height}, digits);
  if (radius == waist) {
    shape.forms.push_back(axial_form(1.0, 1.0, {}, {}, -square(radius)));
  } else {
    // radius(z)² = waist² + (radius² - waist²) (2 z / height)².
    const Dyadic h2 = square(height), waist2 = square(waist);
    shape.forms.push_back(axial_form(h2, h2, (waist2 - square(radius)).scaled(2), {}, -(h2 * waist2)));
  }
  append_slab(shape.forms, 2, range);
  if (radius != waist) {
    shape.error.errors.resize(shape.forms.size());
    shape.error.errors.front()[zz] = 8 * (digits.error(radius) * radius + digits.error(waist) * waist);
  }
  shape.bounds = box_about_axis(widest, range);
  shape.discs = {{shape.bounds.lower.z, widest}, {shape.bounds.upper.z, widest}};
  return Solid::leaf(std::move(shape));
}

Solid halfspace(Vector normal, double distance, Digits digits) {
  require_finite("halfspace", {normal.x, normal.y, normal.z, distance});
  return Solid::leaf(detail::halfspace_shape(detail::plane_form("halfspace", normal, distance), digits));
}

}  // namespace csgcast
