// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "csg/base/transform.h"
#include "csg/base/vector.h"
#include "tests/support/random_solid.h"

namespace csgcast::test {

/// Points whose convex hulls are hard in one way each. All are finite; unless said otherwise of size about 1 near the
/// origin and not all in one plane.
using PointCloud = std::vector<Point>;

/// On the unit sphere, to rounding: every point a corner.
PointCloud sphere_points(RandomSolids& random, int count);
/// Some of the integer lattice {0 .. 4}³: many coplanar, collinear and repeated points. May lie in one plane.
PointCloud lattice_points(RandomSolids& random, int count);
/// Both sides of a tilted sheet of this thickness.
PointCloud sliver_points(RandomSolids& random, double thickness);
/// Rings of this thickness about a tilted segment of length about 2.
PointCloud needle_points(RandomSolids& random, double thickness);
/// A grid over a tilted plane, every coordinate up to one ulp off, and one point well away from it.
PointCloud rough_grid_points(RandomSolids& random);
/// OpenSCAD's sphere(1, $fn = facets): rings of rounded sines and cosines, coplanar in fours but for the rounding.
PointCloud faceted_sphere_points(int facets);
/// OpenSCAD's cylinder(h, r1, r2, $fn = facets), h being 2.
PointCloud faceted_cylinder_points(int facets, double bottom_radius, double top_radius);
/// The corners of two tetrahedra on different sides of a face that they share; small integers.
struct GluedPair {
  PointCloud first;
  PointCloud second;
};
GluedPair glued_tetrahedra(RandomSolids& random);

/// Every point times `scale` plus `offset`, rounded.
PointCloud placed(PointCloud points, double scale, Vector offset);

/// The next double above (steps > 0) or below, `steps` times.
double ulps_off(double x, int steps);

/// Twelve random entries: mirrored half of the time, never singular.
Transform random_affine(RandomSolids& random);
/// Small integers, mirrored half of the time, never singular: what it does to small integers is exact in doubles.
Transform integer_affine(RandomSolids& random);
/// One of rotation, translation, scaling and mirroring, as a scene would say it.
Transform scene_transform(RandomSolids& random);

}  // namespace csgcast::test
