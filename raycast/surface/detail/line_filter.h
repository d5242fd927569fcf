// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "raycast/surface/predicates.h"

namespace csgcast::detail {

// The first rung of the ladder: crossings in double with a running error bound, or nothing if the bound leaves open
// which crossings exist. The constants in the bounds count roundings; docs/accuracy.md derives them.

std::optional<LineCrossings> filtered_plane(const LineFrame& line, const Surface& plane);
std::optional<LineCrossings> filtered_quadric(const LineFrame& line, const Surface& quadric);
/// The crossings with the surface that the line departs from, after its start.
std::optional<LineCrossings> filtered_departure(const Line& line, const Surface& surface);

}  // namespace csgcast::detail
