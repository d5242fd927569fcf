// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "measure/sheet/measures.h"
#include "raycast/scene/scene.h"

namespace csgcast {

/// One node, as if it were alone and of one density.
///
/// Throws Error(bad_value) for errors that are not positive, or a density that is negative or not finite; Cancelled.
Measures measure(const Scene& scene, NodeId node, double density, const MeasureOptions& options = {});

/// The whole solid and each of its parts.
struct SceneMeasures {
  /// The mass and what follows from it are those of the parts with their densities, and of the rest with density 1.
  /// Where parts overlap the first has the place.
  Measures whole;
  std::vector<Measures> parts;  ///< each as if it were alone
};

/// Throws likewise.
SceneMeasures measure(const Scene& scene, const MeasureOptions& options = {});

}  // namespace csgcast
