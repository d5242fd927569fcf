// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "raycast/cells/build/cell_data.h"

namespace csgcast::detail {

// The expected cost of a ray, in units of the test of a surface.

constexpr double cost_of_node = 1.0;
constexpr double cost_of_constant = 0.3;  ///< the cost of a cell that no surface crosses

/// The cost of a cell that this many surfaces cross. It grows by their square if the cell has no table.
constexpr double cost_of_cell(std::size_t surfaces) {
  if (surfaces == 0) return cost_of_constant;
  const double n = static_cast<double>(surfaces);
  return surfaces <= Cell::table_slots ? 1.5 + n : 4 + 2 * n + n * n / 8;
}

}  // namespace csgcast::detail
