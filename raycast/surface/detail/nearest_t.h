// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/surface/predicates.h"

namespace csgcast::detail {

/// The t of a crossing, correctly rounded. It comes from one Newton step on a residual in twofold arithmetic. If the
/// error bound leaves the rounding open it comes from the twofold root, and if that does so too, from the exact root.
/// Source of the rounding test: Ziv 1991.
double nearest_t(const Line& line, const CrossingView& crossing, ExactCalls& calls);

}  // namespace csgcast::detail
