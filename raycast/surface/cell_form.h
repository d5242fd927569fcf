// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "csg/base/vector.h"
#include "raycast/surface/surface.h"

namespace csgcast {

/// A surface's form in the coordinates in which space is cut into boxes, about a center: f(center + q).
struct CellForm {
  Surface::Coefficients c{};
  Vector center;
  double off = 0;  ///< what it may differ by from the surface's, beyond the rounding of its numbers
};

/// An axis-aligned box in those coordinates; sides may be infinite.
struct CellBox {
  Vector lower;
  Vector upper;
};

/// A box of the scene in the frame's coordinates. Rounds by less than 2^-50 of numbers below 4.
CellBox in_frame(const Box& box, const Frame& frame);

/// A form about the middle of a box: value + gradient . d + bend(d) for d up to half the box's sides.
struct LocalForm {
  double value = 0;
  Vector gradient;
  std::array<double, 6> bend{};  ///< xx, yy, zz, xy, xz, yz, as of QuadricForm::Term
  double slack = 0;              ///< more than the exact form of the surface differs from this one, anywhere in the box
};

/// Precondition: the box is finite. `slack` covers what the rounding of the form, of the box's middle and of the sums
/// may hide.
LocalForm local_form(const CellForm& form, const CellBox& box);
/// That slack; of a box within another one it is at most the other's.
double slack_of(const CellForm& form, const CellBox& box);
/// The form with a slack that is known.
LocalForm local_form(const CellForm& form, const CellBox& box, double slack);

}  // namespace csgcast
