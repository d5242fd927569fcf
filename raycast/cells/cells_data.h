// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "raycast/cells/build/cell_data.h"
#include "raycast/cells/cells.h"

namespace csgcast {

/// The data of cells. A public header names the type only, and only code that casts packets sees its content.
struct Cells::Data : detail::CellData {
  explicit Data(detail::CellData&& data) : CellData(std::move(data)) {}
};

}  // namespace csgcast
