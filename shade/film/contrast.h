// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace csgcast::detail {

/// The square root of a channel of light, as 8-bit pictures and eyes weigh it, nearly (sRGB is a power of 1/2.2). Its
/// rounding is that of IEEE 754, the same on every machine.
template <class Number>
Number perceived(Number light) {
  return std::sqrt(std::max(Number(0), light));
}

/// Perceived lights that differ by more than this do not look alike: six steps of 8 bits.
constexpr double least_contrast = 6.0 / 256;

}  // namespace csgcast::detail
