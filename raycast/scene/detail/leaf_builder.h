// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "csg/exact/affine.h"
#include "csg/solid/solid.h"
#include "raycast/scene/detail/surface_table.h"
#include "raycast/scene/detail/surface_welding.h"
#include "raycast/scene/scene.h"
#include "raycast/weld/provenance.h"

namespace csgcast::detail {

/// The placement of a solid in the world.
struct Placement {
  std::shared_ptr<const ExactAffine> world_from_solid;  ///< null: the identity
  Provenance::ChainId chain = 0;                        ///< the same transform as a chain; kept for welding only
};

/// Appends leaves to the tables of a scene. Their half-spaces are taken to the world exactly, and get their surfaces.
class LeafBuilder {
 public:
  /// All arguments must outlive this. `origins` records where each surface comes from; null if nobody needs that.
  LeafBuilder(SceneTables& tables, SurfaceTable& surfaces, SurfaceOrigins* origins)
      : tables_(tables), surfaces_(surfaces), origins_(origins) {}

  /// Completes `leaf` with the half-spaces of a solid that is a leaf, and appends it. Returns the leaf's box in the
  /// world, without a margin. A leaf without an inside is left out, and nothing is returned.
  ///
  /// Throws Error(limit) if the solid is too large, too small or too far away.
  std::optional<Box> add(const Solid& solid, const Placement& placement, Leaf leaf);

 private:
  bool add_half_spaces(const Solid& solid, const Placement& placement, Leaf& leaf, const Box& box);
  bool add_half_space(const HalfSpace& half_space, const Leaf& leaf);
  const LeafFunction* function_of(const LeafShape& shape);

  SceneTables& tables_;
  SurfaceTable& surfaces_;
  SurfaceOrigins* origins_;
  std::map<const TruthFormula*, const LeafFunction*> functions_;  // the functions made so far
};

}  // namespace csgcast::detail
