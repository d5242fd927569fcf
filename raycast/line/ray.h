// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>

#include "csg/base/ids.h"
#include "csg/base/vector.h"

namespace csgcast {

/// The points origin + t direction. The six doubles are exact. t counts in units of the direction, whose length need
/// not be 1.
class Ray {
 public:
  /// The range in which nothing overflows or underflows: every coordinate of origin and direction is at most `greatest`
  /// in magnitude, and the longest coordinate of the direction is at least `least_direction`.
  static constexpr double greatest = 0x1p400;
  static constexpr double least_direction = 0x1p-400;

  /// True if origin and direction are within that range. A zero direction is not. Precondition: both are finite.
  static bool in_range(Point origin, Vector direction);

  /// Throws Error(bad_value) if the direction is zero or a number is not finite. Throws Error(limit) if a number is out
  /// of the range.
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
