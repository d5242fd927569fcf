// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "raycast/cells/build/cell_ground.h"
#include "raycast/cells/formula/formula.h"

namespace csgcast::detail {

/// A formula as a union of conjunctions less others.
struct Conjunctions {
  struct Side {
    SurfaceId surface;
    LeafId leaf;
    bool wants_positive = false;
    bool is_one = true;  ///< true if no other leaf of the conjunction has the surface
  };
  /// One conjunction. It holds where all of its sides [first, first + count) do.
  struct Part {
    CellBox box;  ///< holds the conjunction; if that is empty, a lower side is above the upper one
    std::uint32_t first = 0;
    std::uint16_t count = 0;
    bool is_subtracted = false;
  };

  std::vector<Part> parts;
  std::vector<Side> sides;
};

/// The formula as such a union, as far as it matters in the box `everything`. Returns nothing if the formula is not of
/// this shape, or has a surface that lanes cannot compute.
std::optional<Conjunctions> conjunctions_of(const CellGround& ground, const Formula& formula,
                                            const CellBox& everything);

}  // namespace csgcast::detail
