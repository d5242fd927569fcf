// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "csg/solid/solid.h"
#include "raycast/scene/detail/regions.h"
#include "raycast/scene/detail/surface_table.h"
#include "raycast/scene/detail/surface_welding.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// A solid whose transforms, looks and parts have been worked into its leaves.
struct Flattened {
  SceneTables tables;        ///< leaves, half-spaces, nodes, operations, parts and looks; the rest is empty
  SurfaceTable surfaces;     ///< what the half-spaces' ids stand for
  std::vector<Body> bodies;  ///< in file order
  std::optional<SurfaceOrigins> origins;  ///< where the surfaces come from, if they may be welded
};

/// Flattens a solid in one walk over its tree, in file order, without recursion. `mode` tells whether the surfaces may
/// be welded. Parts have no nodes yet, leaves no regions. Throws Error(limit) and Error(usage) as compile() does.
Flattened flatten(const Solid& solid, Welding::Mode mode);

}  // namespace csgcast::detail
