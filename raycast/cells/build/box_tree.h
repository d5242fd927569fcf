// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/cells/build/cell_builder.h"

namespace csgcast::detail {

/// Adds the hierarchy of boxes to the cells of a solid, if its formula is a bounded union of conjunctions less others,
/// so many that it pays, and a line meets few of them.
void add_box_tree(const CellGround& ground, const Formula& whole, CellData& data);

}  // namespace csgcast::detail
