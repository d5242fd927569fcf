// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "csg/ids.h"
#include "csg/vector.h"

namespace csgcast {

/// One crossing of the ray's line with a surface: the lower (root 0) or upper (root 1) one. Without a surface it is an end that no surface
/// makes: where the query's span cut the interval off, or an infinite end.
struct Crossing {
  double t = 0;
  SurfaceId surface;
  std::uint8_t root = 0;
};

/// A run of t inside the solid, entry before exit.
struct Interval {
  Crossing entry;
  Crossing exit;
};

/// Sorted, disjoint, non-touching intervals.
using IntervalList = std::vector<Interval>;

enum class Passage : std::uint8_t { entry, exit };

/// A crossing that the solid's boundary keeps.
struct Hit {
  Crossing crossing;
  Passage passage = Passage::entry;
};

/// Where a hit belongs in the uncompiled tree.
struct Attribution {
  LeafId leaf;
  PartId part;    ///< not valid outside every named part
  LookId look;    ///< what to shade the face with
  Normal normal;  ///< unit, out of the solid
};

enum class Location : std::uint8_t { inside, outside, boundary };

}  // namespace csgcast
