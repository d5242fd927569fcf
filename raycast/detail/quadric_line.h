// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/predicates.h"

namespace csgcast::detail {

/// The crossings of a line with a quadric in plain double, from the line's closest approach to the surface's centre, so
/// that a distant origin costs no accuracy.  Source: Haines and Günther, Precision Improvements for Ray/Sphere
/// Intersection, Ray Tracing Gems 2019, generalised.
LineCrossings quadric_crossings(const Line& line, SurfaceId id, const Surface& quadric);

}  // namespace csgcast::detail
