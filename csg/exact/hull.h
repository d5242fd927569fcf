// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "csg/base/vector.h"

namespace csgcast {

/// A triangulated convex hull of points: indices into the points, counter-clockwise seen from outside. Coplanar
/// triangles are kept apart.
using HullTriangle = std::array<std::uint32_t, 3>;

/// The sign of the determinant |b-a, c-a, d-a|: +1 if d is on the side to which (b-a) x (c-a) points, exact for all
/// finite doubles.
int orientation(Point a, Point b, Point c, Point d);

/// The exact hull. It is empty if all points lie in one plane. The expected time is O(n log n). Repeated points are
/// allowed. The result is deterministic.
std::vector<HullTriangle> convex_hull(std::span<const Point> points);

}  // namespace csgcast
