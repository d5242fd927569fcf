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
  SurfaceTable surfaces;     ///< the surfaces that the half-spaces' ids refer to
  std::vector<Body> bodies;  ///< in file order
  std::optional<SurfaceOrigins> origins;  ///< the sources of the surfaces, if they may be welded
};

/// Flattens a solid in one walk over its tree, in file order, without recursion. `mode` says if the surfaces may be
/// welded. In the result, parts have no nodes yet and leaves no regions. Throws Error(limit) and Error(usage) as
/// compile() does.
Flattened flatten(const Solid& solid, Welding::Mode mode);

}  // namespace csgcast::detail
