// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/surface/predicates.h"

namespace csgcast::detail {

/// Crossings in double by the formulas of line_filter.h without their bounds: sudden wrong answers at tangents, edges
/// and coincidences. Only to measure certification against.  Source of the closest approach: Haines and Guenther 2019,
/// Ray Tracing Gems, chapter 7, generalised.
LineCrossings uncertified_crossings(const Line& line, SurfaceId id, const Surface& surface, ExactCalls& calls);

}  // namespace csgcast::detail
