// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "raycast/cells/build/cell_data.h"

namespace csgcast::detail {

// What a ray is expected to cost, in units of the test of a surface.

constexpr double cost_of_node = 1.0;
constexpr double cost_of_constant = 0.3;  ///< of a cell that no surface crosses

/// The cost of a cell that so many surfaces cross: without a table for a few of them it grows by their square.
constexpr double cost_of_cell(std::size_t surfaces) {
  if (surfaces == 0) return cost_of_constant;
  const double n = static_cast<double>(surfaces);
  return surfaces <= Cell::table_slots ? 1.5 + n : 4 + 2 * n + n * n / 8;
}

}  // namespace csgcast::detail
