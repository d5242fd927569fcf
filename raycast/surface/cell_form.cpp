// SPDX-License-Identifier: MIT
#include "raycast/surface/cell_form.h"

#include <cmath>

#include "csg/base/length.h"
#include "csg/base/precondition.h"
#include "csg/exact/quadric_form.h"

namespace csgcast {

CellBox in_frame(const Box& box, const Frame& frame) {
  CellBox result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.lower[axis] = std::ldexp(box.lower[axis] - frame.center[axis], -frame.exponent);
    result.upper[axis] = std::ldexp(box.upper[axis] - frame.center[axis], -frame.exponent);
  }
  return result;
}

LocalForm local_form(const CellForm& form, const CellBox& box) { return local_form(form, box, slack_of(form, box)); }

LocalForm local_form(const CellForm& form, const CellBox& box, double slack) {
  CSGCAST_PRECONDITION(is_finite(box.lower) && is_finite(box.upper));
  using Form = QuadricForm;
  const auto& c = form.c;
  const Vector p = 0.5 * (box.upper + box.lower) - form.center;
  LocalForm local;
  local.gradient = {2 * c[Form::xx] * p.x + c[Form::xy] * p.y + c[Form::xz] * p.z + c[Form::x],
                    2 * c[Form::yy] * p.y + c[Form::xy] * p.x + c[Form::yz] * p.z + c[Form::y],
                    2 * c[Form::zz] * p.z + c[Form::xz] * p.x + c[Form::yz] * p.y + c[Form::z]};
  local.value = (c[Form::xx] * p.x + c[Form::xy] * p.y + c[Form::xz] * p.z + c[Form::x]) * p.x +
                (c[Form::yy] * p.y + c[Form::yz] * p.z + c[Form::y]) * p.y + (c[Form::zz] * p.z + c[Form::z]) * p.z +
                c[Form::one];
  for (std::size_t i = 0; i < local.bend.size(); ++i) local.bend[i] = c[i];
  local.slack = slack;
  return local;
}

double slack_of(const CellForm& form, const CellBox& box) {
  using Form = QuadricForm;
  const auto& c = form.c;
  const Vector half = 0.5 * (box.upper - box.lower);
  const Vector p = 0.5 * (box.upper + box.lower) - form.center;
  // `magnitude` bounds the sum of the magnitudes of all terms. `moved` bounds the change of the form if the argument
  // moves by as much as the magnitudes of the coordinates. Rounding moves the argument by a small share of that.
  const Vector reach{std::fabs(p.x) + half.x, std::fabs(p.y) + half.y, std::fabs(p.z) + half.z};
  const Vector middle = 0.5 * (box.upper + box.lower);
  double magnitude = std::fabs(c[Form::one]);
  double moved = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double slope = std::fabs(c[Form::x + i]);
    for (std::size_t j = 0; j < 3; ++j) {
      const double bend = std::fabs(c[Form::second_degree(i, j)]) * reach[j];
      slope += i == j ? 2 * bend : bend;
      if (i <= j) magnitude += bend * reach[i];
    }
    magnitude += std::fabs(c[Form::x + i]) * reach[i];
    moved += slope * (std::fabs(middle[i]) + std::fabs(form.center[i]) + half[i]);
  }
  // The rounding of a coefficient and some twenty operations comes to less than 2^-48 of `magnitude`. The rounding of
  // differences of coordinates comes to less than 2^-51 of `moved`.
  return 0x1p-47 * magnitude + 0x1p-50 * moved + form.off;
}

}  // namespace csgcast
