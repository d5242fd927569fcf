// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "raycast/surface/cell_form.h"
#include "raycast/surface/sides.h"

namespace csgcast::detail {

/// A bound on the error of a computed form, as a share of the sum of the magnitudes of all terms. The rounding of a
/// coefficient, its change to the cells' axes and some twenty operations come to less than 2^-47.
constexpr double form_tolerance = 0x1p-46;

/// The sides of a surface that a box may meet, computed from the form about the box's middle. `half` is half of the
/// box's sides. The answer is `negative` or `positive` only if the form has that sign everywhere in the box by more
/// than its slack. For planes, and for forms without mixed terms, the answer is `both` only if that is not the case.
Sides sides_of(const LocalForm& form, Vector half);
/// The same for a box with infinite sides. The answer is `both`, unless the form is linear and does not both grow
/// without bound along one side and fall along another.
Sides sides_far_out(const CellForm& form, const CellBox& box);
/// The same for the points of a box itself, whose coordinates are exact. Precondition: the box is finite.
Sides sides_within(const CellForm& form, const CellBox& box);

/// The same for the points of a box in the frame's coordinates, by a surface's ten numbers: SurfaceKind::sides_in.
Sides sides_by_form(const Surface& surface, const Frame& frame, const CellBox& box);

/// The slack of a form about the middle of a box. It also covers errors of the coordinates of places along rays, within
/// |q| < 8. Precondition: the box is finite.
double slack_of_lines(const CellForm& form, const CellBox& box);

constexpr std::uint32_t all_corners = 0xFF;  ///< one bit for each corner of a box
/// The corners of a box where the computed value of a form about its middle is negative. Bits 0, 1 and 2 of a corner's
/// number are set if the corner is on the upper side along x, y and z. `half` is half of the box's sides.
std::uint32_t negative_corners(const LocalForm& form, Vector half);

/// A bound on how fast a form changes in a box: if a place moves by at most d along each axis, the form changes by at
/// most d times this bound.
double steepness(const LocalForm& form, Vector half);

/// A measure of how alike two forms change in a box: the scalar products of their slopes, and of their bends.
struct Likeness {
  double slopes = 0;
  double bends = 0;
};
Likeness likeness(const LocalForm& f, const LocalForm& g, Vector half);

/// A form, or its negative (sign = -1).
struct Signed {
  const LocalForm& form;
  double sign = 1;
};

/// True if g is certainly negative in a box wherever f is at most 0. The test: for one of two s > 0, g - s f is
/// negative everywhere in the box. `half` is half of the box's sides, `between` the likeness of the two forms without
/// their signs, `own` the likeness of f with itself.
bool implies(const Signed& f, const Signed& g, Vector half, const Likeness& between, const Likeness& own);
inline bool implies(const LocalForm& f, const LocalForm& g, Vector half) {
  return implies({f}, {g}, half, likeness(f, g, half), likeness(f, f, half));
}

}  // namespace csgcast::detail
