// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "csg/base/box.h"
#include "raycast/line/ray.h"

namespace csgcast::detail {

/// Tells whether the line may meet the box within the span, and narrows the span to where it may. For culling only: the
/// answer is true wherever the line does meet the box, and sometimes where it does not.
///
/// (side - o) / d rounds twice, so it is off by a relative 2u + u² < 2^-51. The slack of 2^-40 also covers the rounding
/// of the span's ends.
inline bool may_meet(const Box& box, const Ray& ray, Span& span) {
  constexpr double slack = 0x1p-40;
  const Point o = ray.origin();
  const Vector d = ray.direction();
  // The span's ends are widened by a product and not a sum: an infinite end stays as it is, and a crossing may lie
  // beyond the doubles.
  double near = span.from * (1 - std::copysign(slack, span.from));
  double far = span.to * (1 + std::copysign(slack, span.to));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0) {
      if (o[axis] < box.lower[axis] || o[axis] > box.upper[axis]) return false;
      continue;
    }
    double t0 = (box.lower[axis] - o[axis]) / d[axis];
    double t1 = (box.upper[axis] - o[axis]) / d[axis];
    if (t0 > t1) std::swap(t0, t1);
    near = std::max(near, t0 - slack * std::fabs(t0));
    far = std::min(far, t1 + slack * std::fabs(t1));
  }
  span = {near, far};
  return near <= far;
}

}  // namespace csgcast::detail
