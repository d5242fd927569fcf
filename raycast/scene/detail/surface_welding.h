// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "csg/base/box.h"
#include "raycast/scene/detail/surface_table.h"
#include "raycast/scene/scene.h"
#include "raycast/weld/provenance.h"
#include "raycast/weld/welding.h"

namespace csgcast::detail {

/// The origins of a scene's surfaces. Welding needs them.
struct SurfaceOrigins {
  /// States that a leaf owns a surface: the surface belongs to one of the leaf's forms.
  struct Ownership {
    SurfaceId surface;
    Provenance::Source source;
  };

  Provenance provenance;
  std::vector<Ownership> ownerships;  ///< in the order of the leaves
};

/// Welds the surfaces of a scene whose leaves have their half-spaces already, and returns a report.
///
/// `everything` holds what is bounded; it is null if there is nothing. Surfaces that weld become one surface in the
/// table, ids close up, and half-spaces get the new ids. If a leaf then has both sides of one surface, it has no
/// inside, and its node becomes an empty one. Precondition: the mode is not off.
WeldReport weld_surfaces(const Welding& welding, const Box& everything, SurfaceOrigins origins, SurfaceTable& surfaces,
                         SceneTables& tables);

}  // namespace csgcast::detail
