// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "csg/base/box.h"
#include "raycast/line/ray.h"

namespace csgcast::detail {

/// Whether the line may meet the box within the span: never false where it does. For culling only. Narrows the span to
/// where it may.
///
/// (side - o) / d rounds twice, so by a relative 2u + u² < 2^-51; the slack of 2^-40 also covers the rounding of the
/// span's ends.
inline bool may_meet(const Box& box, const Ray& ray, Span& span) {
  constexpr double slack = 0x1p-40;
  const Point o = ray.origin();
  const Vector d = ray.direction();
  // A product leaves an infinite end as it is: a crossing may lie beyond the doubles.
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
