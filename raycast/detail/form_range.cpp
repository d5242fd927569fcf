// SPDX-License-Identifier: MIT
#include "raycast/detail/form_range.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace csgcast::detail {
namespace {

using Form = QuadricForm;
// Of the sum of the magnitudes of all terms: a coefficient's rounding, that of turning it into the cells' axes and some
// twenty operations come to less than 2^-47.
constexpr double tolerance = 0x1p-46;

// The greatest value of slope h + bend h² over |h| <= reach.
double greatest(double slope, double bend, double reach) {
  const double s = std::fabs(slope);
  if (bend < 0 && s < -2 * bend * reach) return s * s / (-4 * bend);
  return (s + bend * reach) * reach;
}

// Over a box with infinite sides: f is linear and does not change along them, or it has both signs.
Sides sides_far_out(const CellForm& form, const CellBox& box) {
  const auto& c = form.c;
  for (std::size_t i = 0; i < Form::x; ++i) {
    if (c[i] != 0) return Sides::both;
  }
  double value = c[Form::one];
  double spread = 0;
  double magnitude = std::fabs(value);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double slope = c[Form::x + axis];
    if (slope == 0) continue;
    const double low = box.lower[axis] - form.center[axis];
    const double high = box.upper[axis] - form.center[axis];
    if (!std::isfinite(low) && !std::isfinite(high)) return Sides::both;
    if (!std::isfinite(low) || !std::isfinite(high)) {
      // The sign at the finite end is the least extreme one; both if another axis is infinite the other way.
      const double end = std::isfinite(low) ? low : high;
      const bool grows = (std::isfinite(low)) == (slope > 0);
      if (spread != 0 && std::isinf(spread) && (spread > 0) != grows) return Sides::both;
      spread = grows ? HUGE_VAL : -HUGE_VAL;
      value += slope * end;
      magnitude += std::fabs(slope * end);
      continue;
    }
    const double middle = 0.5 * (low + high);
    value += slope * middle;
    magnitude += std::fabs(slope) * (std::fabs(low) + std::fabs(high));
  }
  double finite_spread = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double size = box.upper[axis] - box.lower[axis];
    if (std::isfinite(size)) finite_spread += std::fabs(c[Form::x + axis]) * 0.5 * size;
  }
  const double slack = finite_spread + tolerance * magnitude;
  if (value > slack && !(spread < 0)) return Sides::positive;
  if (value < -slack && !(spread > 0)) return Sides::negative;
  return Sides::both;
}

}  // namespace

Sides sides_in(const CellForm& form, const CellBox& box) {
  const auto& c = form.c;
  const Vector half = 0.5 * (box.upper - box.lower);
  if (!is_finite(half)) return sides_far_out(form, box);
  const Vector p = 0.5 * (box.upper + box.lower) - form.center;
  const Vector gradient{2 * c[Form::xx] * p.x + c[Form::xy] * p.y + c[Form::xz] * p.z + c[Form::x],
                        2 * c[Form::yy] * p.y + c[Form::xy] * p.x + c[Form::yz] * p.z + c[Form::y],
                        2 * c[Form::zz] * p.z + c[Form::xz] * p.x + c[Form::yz] * p.y + c[Form::z]};
  const double at_middle = (c[Form::xx] * p.x + c[Form::xy] * p.y + c[Form::xz] * p.z + c[Form::x]) * p.x +
                           (c[Form::yy] * p.y + c[Form::yz] * p.z + c[Form::y]) * p.y +
                           (c[Form::zz] * p.z + c[Form::z]) * p.z + c[Form::one];
  const double mixed = std::fabs(c[Form::xy]) * half.x * half.y + std::fabs(c[Form::xz]) * half.x * half.z +
                       std::fabs(c[Form::yz]) * half.y * half.z;
  const double reach = longest(p) + longest(half);
  double bend = 0;
  for (std::size_t i = 0; i < Form::x; ++i) bend += std::fabs(c[i]);
  const double slope = std::fabs(c[Form::x]) + std::fabs(c[Form::y]) + std::fabs(c[Form::z]);
  // Coordinates up to 8 may be off by 2^-49 each: that moves f by the gradient's bound times as much.
  const double slack = tolerance * ((bend * reach + slope) * (reach + 8) + bend * reach + std::fabs(c[Form::one]));
  double up = mixed;
  double down = mixed;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    up += greatest(gradient[axis], c[axis], half[axis]);
    down += greatest(gradient[axis], -c[axis], half[axis]);
  }
  if (at_middle - down > slack) return Sides::positive;
  if (at_middle + up < -slack) return Sides::negative;
  return Sides::both;
}

}  // namespace csgcast::detail
