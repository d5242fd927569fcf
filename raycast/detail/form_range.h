// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "csg/vector.h"
#include "raycast/surface.h"

namespace csgcast::detail {

/// Where a surface is seen to be within a box.
enum class Sides : std::uint8_t { negative, positive, both };

/// A surface's form in the coordinates in which cells are cut, about a center: f(center + q).
struct CellForm {
  Surface::Coefficients c{};
  Vector center;
};

/// An axis-aligned box in those coordinates; sides may be infinite.
struct CellBox {
  Vector lower;
  Vector upper;
};

/// The sides of the surface that the box may meet: `negative` or `positive` only if f has that sign everywhere in it,
/// by more than what the rounding of the form, of the coordinates within |q| < 8 and of this function may hide. Exact
/// up to that for planes and for forms without mixed terms.
Sides sides_in(const CellForm& form, const CellBox& box);

}  // namespace csgcast::detail
