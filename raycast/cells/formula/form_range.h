// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "raycast/surface/cell_form.h"

namespace csgcast::detail {

/// Of the sum of the magnitudes of all terms of a form: a coefficient's rounding, that of turning it into the cells'
/// axes and some twenty operations come to less than 2^-47.
constexpr double form_tolerance = 0x1p-46;

/// Where a surface is seen to be within a box.
enum class Sides : std::uint8_t { negative, positive, both };

/// The sides of a surface that a box may meet, by its form about the box's middle: `negative` or `positive` only if the
/// form has that sign everywhere in it, by more than its slack. Exact up to that for planes and for forms without mixed
/// terms. `half`: of the box's sides.
Sides sides_of(const LocalForm& form, Vector half);
/// The same of a box with infinite sides: f is linear and does not change along them, or it has both signs.
Sides sides_far_out(const CellForm& form, const CellBox& box);
/// The same for places of a box itself, whose coordinates are exact. Precondition: it is finite.
Sides sides_within(const CellForm& form, const CellBox& box);

/// The slack of a form about the middle of a box that also covers what coordinates within |q| < 8 are off.
/// Precondition: the box is finite.
double slack_of_lines(const CellForm& form, const CellBox& box);

constexpr std::uint32_t all_corners = 0xFF;  ///< of a box, a bit for each
/// Those where a form is negative; the computed value decides.
std::uint32_t negative_corners(const LocalForm& form, Vector half);

/// A bound of what moving a place of the box by at most 1 on each axis changes a form, times how far it is moved.
double steepness(const LocalForm& form, Vector half);

/// How alike two forms change in a box: the products of their slopes, and of their bends.
struct Likeness {
  double slopes = 0;
  double bends = 0;
};
Likeness likeness(const LocalForm& f, const LocalForm& g, Vector half);

/// A form, or its contrary.
struct Signed {
  const LocalForm& form;
  double sign = 1;
};

/// Whether g is negative in a box wherever f is at most 0, as far as that is seen from g - s f being negative
/// everywhere in it for one of two s > 0. `half`: of the box's sides. `between`: of both forms, without their signs;
/// `own`: of f.
bool implies(const Signed& f, const Signed& g, Vector half, const Likeness& between, const Likeness& own);
inline bool implies(const LocalForm& f, const LocalForm& g, Vector half) {
  return implies({f}, {g}, half, likeness(f, g, half), likeness(f, f, half));
}

}  // namespace csgcast::detail
