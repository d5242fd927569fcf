// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "raycast/cell_form.h"

namespace csgcast::detail {

/// Of the sum of the magnitudes of all terms of a form: a coefficient's rounding, that of turning it into the cells'
/// axes and some twenty operations come to less than 2^-47.
constexpr double form_tolerance = 0x1p-46;

/// Where a surface is seen to be within a box.
enum class Sides : std::uint8_t { negative, positive, both };

/// The sides of the surface that the box may meet: `negative` or `positive` only if f has that sign everywhere in it,
/// by more than what the rounding of the form, of the coordinates within |q| < 8 and of this function may hide. Exact
/// up to that for planes and for forms without mixed terms.
Sides sides_in(const CellForm& form, const CellBox& box);
/// The same for places of the box itself, whose coordinates are exact. Precondition: it is finite.
Sides sides_within(const CellForm& form, const CellBox& box);

}  // namespace csgcast::detail
