// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "csg/base/ids.h"

namespace csgcast {

/// A side of a surface f(p) = 0: the one where its canonical form is negative, or the one where it is positive.
enum class Sense : std::uint8_t { negative, positive };

constexpr Sense opposite(Sense sense) { return sense == Sense::negative ? Sense::positive : Sense::negative; }

/// One crossing of the ray's line with a surface, or the end of an interval that no surface makes.
struct Crossing {
  double t = 0;
  SurfaceId surface;      ///< not valid for an infinite end, or for an end where the query's span cuts the interval off
  std::uint8_t root = 0;  ///< its number, from 0, among the surface's crossings that matter to the scene on this line
};

}  // namespace csgcast
