// SPDX-License-Identifier: MIT
#include "raycast/line/frame.h"

#include <algorithm>
#include <cmath>

namespace csgcast {

Frame Frame::around(const Box& bounded_leaves) {
  if (!bounded_leaves.is_finite()) return {};
  const Point center = bounded_leaves.center();
  double reach = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    reach = std::max({reach, bounded_leaves.upper[axis] - center[axis], center[axis] - bounded_leaves.lower[axis]});
  }
  if (!(reach > 0) || !std::isfinite(reach)) return {center, 0};
  return {center, std::ilogb(reach) + 2};  // |q| < 1/2, which leaves room for the rounding of the differences
}

}  // namespace csgcast
