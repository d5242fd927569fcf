// SPDX-License-Identifier: MIT
#pragma once

#include "csg/base/box.h"
#include "raycast/cells/pieces.h"

namespace csgcast::detail {

/// How far a solid reaches along the axes of the scene.
struct Extent {
  Box box;           ///< null if the solid is empty
  double error = 0;  ///< bound on the error of each side
};

/// Precondition: the space is bounded.
Extent extent_of(const Space& space);

}  // namespace csgcast::detail
