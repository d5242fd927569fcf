// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "csg/base/digits.h"
#include "csg/base/vector.h"

namespace csgcast {

/// An affine map p -> rows * (p, 1). Its twelve entries are doubles, fixed once. It is row-major, 3 x 4, and the last
/// column translates.
struct Transform {
  std::array<double, 12> entry{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  // How far entries may be from what was meant; it only affects what welding treats as rounding.
  double linear_error = 0;  ///< of the linear part, beyond what errors() says of each entry by its digits
  double offset_error = 0;  ///< of the last column, likewise
  Digits digits{};          ///< of the text that the entries are from

  double operator()(std::size_t row, std::size_t column) const { return entry[4 * row + column]; }
  bool is_identity() const { return *this == Transform{}; }
  bool is_finite() const;
  /// The most that each entry may be off. An entry that uses all digits is known to half a unit of the last one. So are
  /// shorter ones beside such entries, but not an entry of the linear part that stands alone in its row and column: the
  /// 1 of a turn about an axis, and the factors of a scaling. Precondition: finite entries.
  std::array<double, 12> errors() const;
  friend bool operator==(const Transform& a, const Transform& b) { return a.entry == b.entry; }
};

// `digits` tells how well the arguments are known.

Transform translation(Vector offset, Digits digits = {});
Transform scaling(Vector factors, Digits digits = {});
/// OpenSCAD's rotate([x, y, z]): about x, then y, then z, in degrees. At multiples of 30 and 45 degrees it is exact
/// where a double can be.
Transform rotation(Vector degrees_about_axes, Digits digits = {});
/// OpenSCAD's rotate(a, v): right-handed about `axis` (any non-zero length); the identity for a zero axis.
Transform rotation(double degrees, Vector axis, Digits digits = {});
/// Mirror in the plane through the origin with this normal (any non-zero length); the identity for a zero normal.
Transform mirroring(Vector normal, Digits digits = {});

/// Sine and cosine of an angle in degrees, exact (to the nearest double) at multiples of 30 and 45, as OpenSCAD
/// computes them.
double sin_degrees(double degrees);
double cos_degrees(double degrees);

}  // namespace csgcast
