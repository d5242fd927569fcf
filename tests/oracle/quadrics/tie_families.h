// SPDX-License-Identifier: MIT
#pragma once

#include "tests/stress/families.h"

namespace csgcast::oracle::quadrics {

// Families for the rules about ties: whose face it is, and what it looks like. Look statements and parts stand here and
// there, also within what is subtracted.

/// Unions of named parts, each a tree of boxes on the grid and a few random leaves; rays between grid points, so that
/// faces coincide and rays meet edges and corners.
stress::Family looks_and_parts();

/// Unions of parts, each a tree of planes, boxes, balls, cylinders, paraboloids and cones all of which pass through one
/// point with coordinates that are exact, and rays through that point: nearly every surface crosses there, in many
/// leaves at once.
stress::Family surfaces_through_one_point();

}  // namespace csgcast::oracle::quadrics
