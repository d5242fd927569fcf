// SPDX-License-Identifier: MIT
#include "raycast/line/line_frame.h"

#include <algorithm>
#include <cmath>

#include "csg/base/length.h"
#include "raycast/line/twofold.h"

namespace csgcast {
namespace {

Vector times_power(Vector v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

}  // namespace

LineFrame::LineFrame(const Ray& ray, const Frame& frame) {
  const int direction_exponent = std::ilogb(longest(ray.direction()));
  direction = times_power(ray.direction(), -direction_exponent);
  in_range = times_power(direction, direction_exponent) == ray.direction();
  unit = std::ldexp(1.0, frame.exponent - direction_exponent);
  direction_squared = dot(direction, direction);
  inverse_squared = 1 / direction_squared;

  // o - center is computed exactly, as a sum of two doubles for each axis.
  Vector high;
  Vector low;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const detail::Twofold difference = detail::two_sum(ray.origin()[axis], -frame.center[axis]);
    high[axis] = std::ldexp(difference.high, -frame.exponent);
    low[axis] = std::ldexp(difference.low, -frame.exponent);
  }
  // Any shift gives the same line. The shift to the closest approach keeps `near` small when the ray starts far away.
  if (longest(high) > 2) shift = -dot(high, direction) * inverse_squared;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const detail::Twofold step = detail::two_product(shift, direction[axis]);
    const detail::Twofold sum = detail::two_sum(high[axis], step.high);
    const detail::Twofold at = detail::fast_two_sum(sum.high, sum.low + (step.low + low[axis]));
    near[axis] = at.high;
    near_low[axis] = at.low;
  }
  // With M = |high| + 2 |shift| each of the three low parts is below u M, and their two sums round by a relative u: 8
  // u² M covers them. Scaling into the frame may underflow, which costs less than 2^-1000.
  near_low_error = 0x8p-106 * (longest(high) + 2 * std::fabs(shift)) + 0x1p-1000;
  near_error = 0x1p-53 * longest(near) + near_low_error;
  knows_cube = near_low_error <= 0x1p-4;
}

}  // namespace csgcast
