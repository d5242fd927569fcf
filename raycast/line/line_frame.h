// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/line/frame.h"
#include "raycast/line/ray.h"

namespace csgcast {

/// A ray's line in a frame: q = near + tau direction, where t = (shift + tau) unit. On its longest axis |direction| is
/// in [1, 2). Wherever the ray starts, `near` is close to the frame's center.
///
/// `direction`, `shift` and `unit` are exact. `near` is the exact point at tau = 0, rounded: each of its coordinates is
/// off by at most `near_error`. The sum near + near_low is off by at most `near_low_error`. Source of the exact sums
/// and products: Dekker 1971, Ogita, Rump and Oishi 2005.
struct LineFrame {
  Vector near;
  Vector near_low;
  Vector direction;
  bool in_range = true;  ///< false if scaling the direction underflowed: then the doubles decide nothing
  /// False if `near` is off by so much that it does not tell where the line passes the frame's unit cube. Then the
  /// exact stage decides about surfaces that matter within the cube alone.
  bool knows_cube = true;
  double near_error = 0;
  double near_low_error = 0;
  double shift = 0;
  double unit = 1;  ///< a power of two
  double direction_squared = 1;
  double inverse_squared = 1;  ///< 1 / direction_squared

  LineFrame() = default;
  LineFrame(const Ray& ray, const Frame& frame);

  double t(double tau) const { return (shift + tau) * unit; }
};

}  // namespace csgcast
