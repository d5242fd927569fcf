// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "csg/base/vector.h"

namespace csgcast::text {

/// OpenSCAD's $fn, $fa (degrees) and $fs (length), with its defaults.
struct Fineness {
  double fn = 0;
  double fa = 12;
  double fs = 2;
};

/// The number of sides that OpenSCAD gives a circle; at least 3. A double because $fn may ask for more than any integer
/// type holds; it has no fraction. Source: OpenSCAD 2021.01, Calc::get_fragments_from_r.
double side_count(double radius, const Fineness& fineness);

/// The vertices of OpenSCAD's sphere, ring by ring from the top, each ring from +x counter-clockwise; the solid is
/// their hull. Preconditions: radius > 0, 3 <= sides.
std::vector<Point> sphere_vertices(double radius, int sides);

/// The vertices of OpenSCAD's cylinder, bottom then top, each from +x counter-clockwise; one point in place of a ring
/// of radius 0. Preconditions: height > 0, radii >= 0, 3 <= sides.
std::vector<Point> cylinder_vertices(double bottom, double top, double bottom_radius, double top_radius, int sides);

}  // namespace csgcast::text
