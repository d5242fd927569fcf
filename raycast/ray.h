// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>

#include "csg/ids.h"
#include "csg/vector.h"

namespace csgcast {

/// origin + t direction. The six doubles are exact; t counts in units of the direction, which need not be unit.
class Ray {
 public:
  /// Throws Error(bad_value) for a zero direction or a number that is not finite.
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
