// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/surface/predicates.h"

namespace csgcast::detail {

/// The t of a crossing, correctly rounded: one Newton step on a residual in twofold arithmetic; where its error bound
/// leaves the rounding open, the exact root.  Source of the rounding test: Ziv 1991.
double nearest_t(const Line& line, const CrossingView& crossing, ExactCalls& calls);

}  // namespace csgcast::detail
