// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "raycast/surface/predicates.h"

namespace csgcast::detail {

// The first rung of the ladder: crossings in double with a running error bound, or nothing where the bound leaves open
// which crossings exist. The constants are counted roundings; docs/accuracy.md has the derivation.

std::optional<LineCrossings> filtered_plane(const LineFrame& line, const Surface& plane);
std::optional<LineCrossings> filtered_quadric(const LineFrame& line, const Surface& quadric);
/// Of the surface that the line departs from, towards `side`.
std::optional<LineCrossings> filtered_departure(const Line& line, const Surface& surface);

}  // namespace csgcast::detail
