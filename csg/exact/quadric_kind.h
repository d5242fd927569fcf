// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "csg/base/vector.h"
#include "csg/exact/quadric_form.h"

namespace csgcast {

/// What the zeros of a form of at most second degree are. `circular` and `sphere` are exact: a turn whose matrix was
/// rounded leaves a cylinder that is elliptic by some 1e-16.
enum class QuadricKind : std::uint8_t {
  sphere,
  spheroid,  ///< an ellipsoid with two equal semi-axes
  ellipsoid,
  circular_cylinder,
  elliptic_cylinder,
  parabolic_cylinder,
  hyperbolic_cylinder,
  circular_cone,  ///< both halves
  elliptic_cone,
  circular_paraboloid,
  elliptic_paraboloid,
  hyperbolic_paraboloid,
  circular_hyperboloid_of_one_sheet,
  elliptic_hyperboloid_of_one_sheet,
  circular_hyperboloid_of_two_sheets,
  elliptic_hyperboloid_of_two_sheets,
  plane,
  crossing_planes,
  parallel_planes,
  double_plane,
  line,
  point,
  none,       ///< no real point
  everything  ///< all coefficients are zero
};

/// `elliptic hyperboloid of one sheet`.
const char* word(QuadricKind kind);

/// Decided exactly, by the signs of the invariants of the form's 3 x 3 and 4 x 4 matrices. The form may be any one.
QuadricKind kind_of_quadric(const QuadricForm& form);

/// Where a quadric lies, and how large it is, in the coordinates of its form. It is told in its own axes u, v, w about
/// its center; numbers that its kind does not have are none.
struct QuadricShape {
  QuadricKind kind = QuadricKind::everything;
  /// The centre; an apex or a vertex; of what has a line or a plane of centres, or vertices, the one nearest the
  /// origin. Each coordinate is computed exactly,
  /// then rounded to 128 bits and to the nearest double.
  Point center{};
  /// u, v and w: unit, right-handed. w is the axis of a cylinder, a cone, a paraboloid or a hyperboloid, and the way
  /// that a paraboloid opens; of a parabolic cylinder, v is the way that it opens; u is square to parallel planes.
  std::array<Vector, 3> axes{};
  /// Radians to the true axis, at most, as lines; infinite: undetermined, as round shapes have any axes there.
  std::array<double, 3> axes_error{};
  /// Semi-axes along u, v, w: radii of a sphere or cylinder, of the throat of a hyperboloid, half the distance of
  /// parallel planes. Infinite along w of a cylinder; the imaginary ones of hyperboloids are their conjugates.
  std::array<double, 3> semi_axes{};
  /// Of a cone, in the planes of w with u and of w with v; of crossing planes, between u and each plane. Radians.
  std::array<double, 2> half_angles{};
  /// Of a paraboloid, in the planes of w with u and with v (a hyperbolic one's second opens the other way); of a
  /// parabolic cylinder, the first.
  std::array<double, 2> focal_lengths{};
  /// Of each of these lengths, and of the tangents of the angles: error / value at most, rounding included. Infinite:
  /// lengths differ so much that nothing is sure.
  double relative_error = 0;
};

/// Precondition: the form is not of a plane and not constant. Kinds without a real place but for `line` and `point` are
/// told by their kind alone: the rest is none.
QuadricShape shape_of_quadric(const QuadricForm& form);

}  // namespace csgcast
