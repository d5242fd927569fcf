// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>
#include "csg/base/precondition.h"
#include "raycast/cells/build/cell_axes.h"
#include "raycast/cells/build/cell_data.h"
#include "raycast/cells/build/cell_ground.h"
#include "raycast/cells/formula/formula.h"

namespace csgcast::detail {

/// Cuts the space of a scene's node into cells, each with the formula of the surfaces that cross it. `whole` is the
/// formula of the node, and `ground` is its ground. Sets all of the result except its `boxes`.
///
/// The tree is built from the top down. A child's formula is its parent's, folded by what interval arithmetic shows to
/// be constant in the child. Splits minimise the expected cost of a ray (the surface area heuristic). A part that turns
/// out no cheaper than one cell becomes one cell. Large parts are built side by side by the threads that oneTBB has
/// where this is called. The result does not depend on their number.
CellData build_cells(const CellGround& ground, NodeId node, const Formula& whole);

}  // namespace csgcast::detail
