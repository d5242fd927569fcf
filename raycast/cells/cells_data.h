// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "raycast/cells/build/cell_data.h"
#include "raycast/cells/cells.h"

namespace csgcast {

/// The data of cells: a public header names the type, and only those who cast packets see what it is.
struct Cells::Data : detail::CellData {
  explicit Data(detail::CellData&& data) : CellData(std::move(data)) {}
};

}  // namespace csgcast
