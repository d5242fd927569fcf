// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "raycast/cells/build/cell_data.h"
#include "raycast/cells/cells.h"

namespace csgcast {

struct Cells::Data : detail::CellData {
  explicit Data(detail::CellData&& data) : CellData(std::move(data)) {}
};

}  // namespace csgcast
