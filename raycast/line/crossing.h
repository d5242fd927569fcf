// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "csg/base/ids.h"

namespace csgcast {

/// The side of a surface f(p) = 0: where its canonical form is negative, or where it is positive.
enum class Sense : std::uint8_t { negative, positive };

constexpr Sense opposite(Sense sense) { return sense == Sense::negative ? Sense::positive : Sense::negative; }

/// One crossing of the ray's line with a surface: the first (root 0) or second (root 1) of those that matter to the
/// scene on this line. Without a surface it is an end that no surface makes: where the query's span cut the interval
/// off, or an infinite end.
struct Crossing {
  double t = 0;
  SurfaceId surface;
  std::uint8_t root = 0;
};

}  // namespace csgcast
