// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "raycast/line/twofold_root.h"
#include "raycast/surface/line_crossings.h"

// Planes along a line: the rungs of their ladder that exact arithmetic does not share with other kinds.

namespace csgcast::detail {

/// The crossings in double with a bound on their error. Returns nothing if the bound leaves open which crossings exist.
std::optional<LineCrossings> filtered_plane(const Line& line, SurfaceId id, const Surface& plane);
/// The same formulas without their bounds. Answers are suddenly wrong at tangents, edges and coincidences.
LineCrossings uncertified_plane(const Line& line, SurfaceId id, const Surface& plane);

// The crossings in twofold arithmetic. Returns nothing for the surface that the line departs from.
std::optional<LineCrossings> twofold_plane(const Line& line, SurfaceId id, const Surface& plane);
std::optional<TwofoldRoot> twofold_plane_root(const Line& line, const CrossingView& crossing);

}  // namespace csgcast::detail
