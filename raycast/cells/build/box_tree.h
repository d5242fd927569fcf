// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/cells/build/cell_data.h"
#include "raycast/cells/build/cell_ground.h"
#include "raycast/cells/formula/formula.h"

namespace csgcast::detail {

/// Adds the hierarchy of boxes, and slots for its surfaces, to the cells of a node. It does so only if the node's
/// formula, `whole`, is a bounded union of conjunctions less others, and if boxes promise to be cheaper than cells.
void add_box_tree(const CellGround& ground, const Formula& whole, CellData& data);

}  // namespace csgcast::detail
