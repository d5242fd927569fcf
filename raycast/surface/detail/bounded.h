// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

// The first rung of the ladder is double with a running error bound. This is what the kinds share for it. The constants
// are counted roundings; docs/accuracy.md has the derivation.

namespace csgcast::detail {

/// The relative error of one rounding.
constexpr double unit_roundoff = 0x1p-53;
/// Computed error bounds are sums of a few positive terms. Their own rounding is less than this share.
constexpr double rounding_of_bounds = 1 + 0x1p-40;
/// From any point of the line near its closest approach, the frame's unit cube is within |s| <= reach. Reason: the
/// closest approach to a center in the cube is no farther from a point of the cube than the cube's diagonal, 2 sqrt(3),
/// and |direction| >= 1.
constexpr double reach = 4;

struct Bounded {
  double value;
  double error;

  bool is_certain() const { return std::fabs(value) > error; }
  double least() const { return std::fabs(value) - error; }
  double most() const { return std::fabs(value) + error; }
};

}  // namespace csgcast::detail
