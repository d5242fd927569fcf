// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "measure/section.h"

namespace csgcast {

/// Each loop of a section as points of a polyline, in order; the last point is the first one again where the section is
/// closed. No arc is farther than `tolerance` from its chords, in the scene's unit of length; straight arcs have none
/// between their ends. Bounds that error for the arcs as their numbers are: those are within Section::place_error of
/// the true ends, and are rounded. A tolerance below 2^-50 of an arc's coordinates counts as that much.
///
/// Throws Error(bad_value) for a tolerance that is not above 0 and finite, Error(limit) if more than 2^24 points are
/// needed, Error(usage) for a section that may be unbounded.
std::vector<std::vector<PlanePoint>> section_polylines(const Section& section, double tolerance);

}  // namespace csgcast
