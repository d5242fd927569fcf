// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "csg/base/box.h"
#include "raycast/scene/detail/surface_table.h"
#include "raycast/scene/scene.h"
#include "raycast/weld/provenance.h"
#include "raycast/weld/welding.h"

namespace csgcast::detail {

/// Where the surfaces of a scene come from: welding goes by that.
struct SurfaceOrigins {
  /// A leaf owns a surface: the surface is that of one of the leaf's forms.
  struct Ownership {
    SurfaceId surface;
    Provenance::Source source;
  };

  Provenance provenance;
  std::vector<Ownership> ownerships;  ///< in the order of the leaves
};

/// Welds the surfaces of a scene whose leaves have their half-spaces already, and reports what that did.
///
/// `everything` holds what is bounded; null if there is nothing. Surfaces that weld become one in the table, ids close
/// up, and half-spaces get the new ids. A leaf that has both sides of one surface now has no inside: its node becomes
/// an empty one. Precondition: the mode is not off.
WeldReport weld_surfaces(const Welding& welding, const Box& everything, SurfaceOrigins origins, SurfaceTable& surfaces,
                         SceneTables& tables);

}  // namespace csgcast::detail
