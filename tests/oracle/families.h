// SPDX-License-Identifier: MIT
#pragma once

#include "tests/oracle/subject.h"
#include "tests/support/random_solid.h"

namespace csgcast::oracle {

// One function a family. Each makes a random model: by the product's primitives and transforms, and from the same
// doubles by CGAL.

Model hull_of_sphere_points(test::RandomSolids& random);
Model hull_of_lattice_points(test::RandomSolids& random);
Model some_box(test::RandomSolids& random);
Model sliver(test::RandomSolids& random);
Model needle(test::RandomSolids& random);
Model hull_of_rough_grid(test::RandomSolids& random);
Model faceted_round(test::RandomSolids& random);
/// Of size 1 or 1e-3, 1e6 or 1e9 away.
Model far_hull(test::RandomSolids& random);
/// Of size 2^100 or 2^-100, or 2^400 or 2^-400, where the products of coordinates leave the doubles.
Model scaled_hull(test::RandomSolids& random);
/// Every coordinate has its own exponent, from -40 to 40.
Model hull_of_mixed_magnitudes(test::RandomSolids& random);
/// One to four nested transforms of random entries, mirrors included.
Model affine_image(test::RandomSolids& random);
/// Nested transforms as a scene says them, over boxes and faceted solids.
Model scene_image(test::RandomSolids& random);
/// Bounded, given by random planes or by small-integer planes of which many pass through one point; some redundant;
/// some moved.
Model intersection_of_planes(test::RandomSolids& random);
/// Few planes without order: unbounded or without interior, as it comes.
Model loose_planes(test::RandomSolids& random);

/// Two or three boxes with integer corners in {0 .. 4}, united, intersected or subtracted.
Model flush_boxes(test::RandomSolids& random);
/// The same under nested transforms that all operands share.
Model moved_flush_boxes(test::RandomSolids& random);
/// Two tetrahedra that share a face.
Model glued_pair(test::RandomSolids& random);
/// Hulls of lattice points, which overlap in faces, edges and corners.
Model lattice_hulls(test::RandomSolids& random);
/// A hull and the same points again, one of them an ulp off.
Model almost_equal_pair(test::RandomSolids& random);

}  // namespace csgcast::oracle
