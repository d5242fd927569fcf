// SPDX-License-Identifier: MIT
#include "csg/base/box.h"

#include <algorithm>
#include <cmath>

#include "csg/base/length.h"

namespace csgcast {

bool Box::is_finite() const { return !is_null() && csgcast::is_finite(lower) && csgcast::is_finite(upper); }

bool Box::contains(Point p) const {
  return lower.x <= p.x && p.x <= upper.x && lower.y <= p.y && p.y <= upper.y && lower.z <= p.z && p.z <= upper.z;
}

Point Box::center() const {
  const auto middle = [](double a, double b) { return a == -b ? 0.0 : a / 2 + b / 2; };  // 0 for a whole axis
  return {middle(lower.x, upper.x), middle(lower.y, upper.y), middle(lower.z, upper.z)};
}

Box hull(const Box& a, const Box& b) {
  if (a.is_null()) return b;
  if (b.is_null()) return a;
  Box both;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    both.lower[axis] = std::min(a.lower[axis], b.lower[axis]);
    both.upper[axis] = std::max(a.upper[axis], b.upper[axis]);
  }
  return both;
}

Box intersection(const Box& a, const Box& b) {
  Box common;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    common.lower[axis] = std::max(a.lower[axis], b.lower[axis]);
    common.upper[axis] = std::min(a.upper[axis], b.upper[axis]);
  }
  return common.is_null() ? Box{} : common;
}

}  // namespace csgcast
