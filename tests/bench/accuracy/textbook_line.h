// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/surface/predicates.h"

namespace csgcast::bench {

// Crossings as other programs compute them: each is a `Predicates::crossings`. Floating point decides, without a bound.
// Rays that depart from a surface are not told apart.

/// a t² + 2 b t + c in world coordinates, from the surface's rounded world coefficients; t = (-b ± sqrt(b² - ac)) / a.
LineCrossings plain_crossings(const Line& line, SurfaceId id, const Surface& surface, ExactCalls& calls);

/// The same but for the discriminant, which is b² - ac to about one rounding.  Source: Kahan, On the cost of
/// floating-point computation without extra-precise arithmetic, 2004.
LineCrossings kahan_crossings(const Line& line, SurfaceId id, const Surface& surface, ExactCalls& calls);

/// About the ray's closest approach to the surface's center, which the ray is moved to by a plain transform; the root
/// that does not cancel first, the other from the product of both.  Source: Haines and others, Precision Improvements
/// for Ray/Sphere Intersection, Ray Tracing Gems, 2019, generalised to all quadrics.
LineCrossings shifted_crossings(const Line& line, SurfaceId id, const Surface& surface, ExactCalls& calls);

}  // namespace csgcast::bench
