// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "raycast/cells/build/cell_ground.h"
#include "raycast/cells/formula/formula.h"
#include "raycast/cells/space.h"

namespace csgcast {

/// The content of a space: the part of the tree that matters in it.
struct Space::Content {
  std::shared_ptr<const detail::CellGround> ground;
  detail::Formula formula;
};

}  // namespace csgcast
