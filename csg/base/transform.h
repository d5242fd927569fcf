// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "csg/base/vector.h"

namespace csgcast {

/// An affine map p -> rows * (p, 1). Its twelve entries are doubles, fixed once. It is row-major, 3 x 4, and the last
/// column translates.
struct Transform {
  std::array<double, 12> entry{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  /// Bound on the difference between an entry of the linear part and what the arguments mean, beyond half an ulp of its
  /// own. It only affects what welding treats as rounding.
  double linear_error = 0;

  double operator()(std::size_t row, std::size_t column) const { return entry[4 * row + column]; }
  bool is_identity() const { return *this == Transform{}; }
  bool is_finite() const;
  friend bool operator==(const Transform& a, const Transform& b) { return a.entry == b.entry; }
};

Transform translation(Vector offset);
Transform scaling(Vector factors);
/// OpenSCAD's rotate([x, y, z]): about x, then y, then z, in degrees. At multiples of 30 and 45 degrees it is exact
/// where a double can be.
Transform rotation(Vector degrees_about_axes);
/// OpenSCAD's rotate(a, v): right-handed about `axis` (any non-zero length); the identity for a zero axis.
Transform rotation(double degrees, Vector axis);
/// Mirror in the plane through the origin with this normal (any non-zero length); the identity for a zero normal.
Transform mirroring(Vector normal);

/// Sine and cosine of an angle in degrees, exact (to the nearest double) at multiples of 30 and 45, as OpenSCAD
/// computes them.
double sin_degrees(double degrees);
double cos_degrees(double degrees);

}  // namespace csgcast
