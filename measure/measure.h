// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "measure/sheet/measures.h"
#include "raycast/scene/scene.h"

namespace csgcast {

/// Measures one node, as if it were alone and had one density.
///
/// Throws Error(bad_value) for relative errors that are not positive, and for a density that is negative or not finite.
/// Throws Cancelled.
Measures measure(const Scene& scene, NodeId node, double density, const MeasureOptions& options = {});

/// The measures of the whole solid and of each of its parts.
struct SceneMeasures {
  /// The mass, and what follows from it, comes from the parts with their densities and from the rest with density 1.
  /// Where parts overlap, the first one counts.
  Measures whole;
  std::vector<Measures> parts;  ///< each part as if it were alone
};

/// Throws as measure() of a node does.
SceneMeasures measure(const Scene& scene, const MeasureOptions& options = {});

}  // namespace csgcast
