// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "csg/base/vector.h"

namespace csgcast {

/// A closed axis-aligned box. A null box (lower > upper) holds no point. A degenerate one (lower == upper) still holds
/// some.
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

/// The smallest box that holds both.
Box hull(const Box& a, const Box& b);
/// The points in both boxes. Touching boxes share a degenerate box.
Box intersection(const Box& a, const Box& b);

}  // namespace csgcast
