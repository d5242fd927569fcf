// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "csg/base/transform.h"
#include "tests/support/at.h"

namespace csgcast::bench {

/// Random numbers that are the same everywhere, of six decimals, as files have them.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : random_(seed) {}

  double between(double from, double to) {
    const double share = static_cast<double>(random_() >> 11) * 0x1p-53;
    return std::round((from + (to - from) * share) * 1e6) / 1e6;
  }
  Vector in_cube(double half_side) {
    const double x = between(-half_side, half_side), y = between(-half_side, half_side);
    return {x, y, between(-half_side, half_side)};
  }

 private:
  std::mt19937_64 random_;
};

using test::ball;

}  // namespace csgcast::bench
