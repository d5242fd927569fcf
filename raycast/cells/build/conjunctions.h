// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "raycast/cells/build/cell_builder.h"

namespace csgcast::detail {

/// A formula as a union of conjunctions less others.
struct Conjunctions {
  struct Side {
    SurfaceId surface;
    LeafId leaf;
    bool wants_positive = false;
    bool is_one = true;  ///< no other leaf of the conjunction has the surface
  };
  /// Sides [first, first + count).
  struct Part {
    CellBox box;  ///< holds it; with a lower side above the upper one if there is nothing of it
    std::uint32_t first = 0;
    std::uint16_t count = 0;
    bool is_subtracted = false;
  };

  std::vector<Part> parts;
  std::vector<Side> sides;
};

/// Nothing if the formula is not like that, or has a surface that lanes cannot compute. What lies outside `everything`
/// does not matter.
std::optional<Conjunctions> conjunctions_of(const CellGround& ground, const Formula& formula,
                                            const CellBox& everything);

}  // namespace csgcast::detail
