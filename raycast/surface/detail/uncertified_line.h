// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/surface/predicates.h"

namespace csgcast::detail {

/// Crossings in double by the formulas of line_filter.h without their bounds. They may be wrong at tangents, edges and
/// coincidences, and serve only to measure what certification costs.  Source of the closest approach: Haines and
/// Guenther 2019, Ray Tracing Gems, chapter 7, generalised.
LineCrossings uncertified_crossings(const Line& line, SurfaceId id, const Surface& surface, ExactCalls& calls);

}  // namespace csgcast::detail
