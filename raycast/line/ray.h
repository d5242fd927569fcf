// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>

#include "csg/base/ids.h"
#include "csg/base/vector.h"

namespace csgcast {

/// origin + t direction. The six doubles are exact; t counts in units of the direction, which need not be unit.
class Ray {
 public:
  /// The range in which nothing over- or underflows: coordinates of the origin and of the direction, and the longest
  /// coordinate of the direction.
  static constexpr double greatest = 0x1p400;
  static constexpr double least_direction = 0x1p-400;

  /// Whether finite numbers are within the range; a zero direction is not.
  static bool in_range(Point origin, Vector direction);

  /// Throws Error(bad_value) for a zero direction or a number that is not finite, Error(limit) out of the range.
  Ray(Point origin, Vector direction);

  Point origin() const { return origin_; }
  Vector direction() const { return direction_; }
  /// The point at t, rounded.
  Point at(double t) const { return origin_ + t * direction_; }

 private:
  Point origin_;
  Vector direction_;
};

/// The part of the line that a query looks at: the closed range [from, to] of t.
struct Span {
  double from = 0;
  double to = std::numeric_limits<double>::infinity();

  static constexpr Span line() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
};

}  // namespace csgcast
