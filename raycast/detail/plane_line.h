// SPDX-License-Identifier: MIT
#pragma once

#include <compare>

#include "raycast/predicates.h"

namespace csgcast::detail {

// A plane f and a line o + t d meet at t = -f(o) / (n . d). Floating point with a running bound first; exact dyadic
// numbers where it cannot tell.

LineCrossings plane_crossings(Line& line, SurfaceId id, const Surface& plane);
std::weak_ordering exact_order(Line& line, const CrossingView& a, const CrossingView& b);
std::weak_ordering exact_order(Line& line, const CrossingView& a, double t);

}  // namespace csgcast::detail
