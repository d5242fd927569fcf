// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "raycast/cells/build/cell_builder.h"
#include "raycast/cells/formula/formula.h"
#include "raycast/cells/space.h"

namespace csgcast {

struct Space::Content {
  std::shared_ptr<const detail::CellGround> ground;
  detail::Formula formula;
};

}  // namespace csgcast
