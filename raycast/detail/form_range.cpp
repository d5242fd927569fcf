// SPDX-License-Identifier: MIT
#include "raycast/detail/form_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace csgcast::detail {
namespace {

using Form = QuadricForm;

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
  const double slack = finite_spread + form_tolerance * magnitude;
  if (value > slack && !(spread < 0)) return Sides::positive;
  if (value < -slack && !(spread > 0)) return Sides::negative;
  return Sides::both;
}

// By how much a form may fall below its value in the middle of a box, and rise above.
std::pair<double, double> change_in(const LocalForm& f, Vector half) {
  const double mixed = std::fabs(f.bend[Form::xy]) * half.x * half.y + std::fabs(f.bend[Form::xz]) * half.x * half.z +
                       std::fabs(f.bend[Form::yz]) * half.y * half.z;
  double up = mixed;
  double down = mixed;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    up += greatest(f.gradient[axis], f.bend[axis], half[axis]);
    down += greatest(f.gradient[axis], -f.bend[axis], half[axis]);
  }
  return {down, up};
}

// Of places along rays, whose coordinates are up to 8 and may be off by 2^-49 each: that moves f by the gradient's
// bound times as much.
double slack_of_lines(const CellForm& form, const CellBox& box) {
  const auto& c = form.c;
  const double reach = longest(0.5 * (box.upper + box.lower) - form.center) + 0.5 * longest(box.upper - box.lower);
  double bend = 0;
  for (std::size_t i = 0; i < Form::x; ++i) bend += std::fabs(c[i]);
  const double slope = std::fabs(c[Form::x]) + std::fabs(c[Form::y]) + std::fabs(c[Form::z]);
  return form_tolerance * ((bend * reach + slope) * (reach + 8) + bend * reach + std::fabs(c[Form::one]));
}

}  // namespace

Sides sides_within(const CellForm& form, const CellBox& box) {
  const LocalForm f = local_form(form, box);
  const auto [down, up] = change_in(f, 0.5 * (box.upper - box.lower));
  if (f.value - down > f.slack) return Sides::positive;
  if (f.value + up < -f.slack) return Sides::negative;
  return Sides::both;
}

Sides sides_in(const CellForm& form, const CellBox& box) {
  const Vector half = 0.5 * (box.upper - box.lower);
  if (!is_finite(half)) return sides_far_out(form, box);
  const LocalForm f = local_form(form, box);
  const auto [down, up] = change_in(f, half);
  const double slack = f.slack + slack_of_lines(form, box);
  if (f.value - down > slack) return Sides::positive;
  if (f.value + up < -slack) return Sides::negative;
  return Sides::both;
}

}  // namespace csgcast::detail
