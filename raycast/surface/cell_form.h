// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "csg/base/vector.h"
#include "raycast/surface/surface.h"

namespace csgcast {

/// A surface's form in the coordinates in which space is cut into boxes. It is taken about a center: f(center + q).
struct CellForm {
  Surface::Coefficients c{};
  Vector center;
  double off = 0;  ///< bound on its difference from the surface's form, beyond the rounding of its numbers
};

/// An axis-aligned box in those coordinates; sides may be infinite.
struct CellBox {
  Vector lower;
  Vector upper;
};

/// A box of the scene in the frame's coordinates. Numbers below 4 are off by less than 2^-50 of themselves.
CellBox in_frame(const Box& box, const Frame& frame);

/// A form about the middle of a box: value + gradient . d + bend(d) for d up to half the box's sides.
struct LocalForm {
  double value = 0;
  Vector gradient;
  std::array<double, 6> bend{};  ///< xx, yy, zz, xy, xz, yz, as of QuadricForm::Term
  double slack = 0;              ///< anywhere in the box the exact form differs from this one by less
};

/// A form about the middle of a box. Its slack covers the rounding of the form, of the box's middle and of the sums.
/// Precondition: the box is finite.
LocalForm local_form(const CellForm& form, const CellBox& box);
/// The slack of that form. The slack in a box is at most the slack in a larger box that contains it.
double slack_of(const CellForm& form, const CellBox& box);
/// The same form, for a caller that knows its slack already.
LocalForm local_form(const CellForm& form, const CellBox& box, double slack);

}  // namespace csgcast
