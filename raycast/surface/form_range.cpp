// SPDX-License-Identifier: MIT
#include "raycast/surface/form_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "csg/base/length.h"
#include "csg/base/precondition.h"
#include "csg/exact/quadric_form.h"

namespace csgcast::detail {
namespace {

using Form = QuadricForm;

// The greatest value of slope h + bend h² over |h| <= reach.
double greatest(double slope, double bend, double reach) {
  const double s = std::fabs(slope);
  if (bend < 0 && s < -2 * bend * reach) return s * s / (-4 * bend);
  return (s + bend * reach) * reach;
}

// An upper bound on how far a form, or its negative (sign = -1), rises above its value in the middle of a box.
double rise(const LocalForm& f, double sign, Vector half) {
  double up = std::fabs(f.bend[Form::xy]) * half.x * half.y + std::fabs(f.bend[Form::xz]) * half.x * half.z +
              std::fabs(f.bend[Form::yz]) * half.y * half.z;
  for (std::size_t axis = 0; axis < 3; ++axis) up += greatest(f.gradient[axis], sign * f.bend[axis], half[axis]);
  return up;
}

// True if a g - s f is certainly negative in the whole box.
bool is_negative(const LocalForm& g, double a, const LocalForm& f, double s, Vector half) {
  LocalForm rest;
  rest.value = a * g.value - s * f.value;
  const double slack = g.slack + std::fabs(s) * f.slack;
  if (!(rest.value < -slack)) return false;
  rest.gradient = a * g.gradient - s * f.gradient;
  for (std::size_t i = 0; i < rest.bend.size(); ++i) rest.bend[i] = a * g.bend[i] - s * f.bend[i];
  return rest.value + rise(rest, 1, half) < -slack;
}

}  // namespace

double steepness(const LocalForm& form, Vector half) {
  const auto& bend = form.bend;
  double steepest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    steepest += std::fabs(form.gradient[axis]) + 2 * std::fabs(bend[axis]) * half[axis];
  return steepest + std::fabs(bend[Form::xy]) * (half.x + half.y) + std::fabs(bend[Form::xz]) * (half.x + half.z) +
         std::fabs(bend[Form::yz]) * (half.y + half.z);
}

Likeness likeness(const LocalForm& f, const LocalForm& g, Vector half) {
  Likeness result;
  for (std::size_t axis = 0; axis < 3; ++axis)
    result.slopes += f.gradient[axis] * half[axis] * g.gradient[axis] * half[axis];
  for (std::size_t i = 0; i < f.bend.size(); ++i) result.bends += f.bend[i] * g.bend[i];
  return result;
}

bool implies(const Signed& f, const Signed& g, Vector half, const Likeness& between, const Likeness& own) {
  // The first s gives the difference the least slope, the second the least bend. Two spheres then leave no bend.
  const double sign = f.sign * g.sign;
  const auto leaves_negative = [&](double product, double square) {
    if (!(sign * product > 0)) return false;
    return is_negative(g.form, g.sign, f.form, f.sign * (sign * product / square), half);
  };
  return leaves_negative(between.slopes, own.slopes) || leaves_negative(between.bends, own.bends);
}

// Coordinates of places along rays are at most 8, and may be off by 2^-49 each.
double slack_of_lines(const CellForm& form, const CellBox& box) {
  CSGCAST_PRECONDITION(is_finite(box.lower) && is_finite(box.upper));
  const auto& c = form.c;
  const double reach = longest(0.5 * (box.upper + box.lower) - form.center) + 0.5 * longest(box.upper - box.lower);
  double bend = 0;
  for (std::size_t i = 0; i < Form::x; ++i) bend += std::fabs(c[i]);
  const double slope = std::fabs(c[Form::x]) + std::fabs(c[Form::y]) + std::fabs(c[Form::z]);
  // An error of the place changes f by at most that error times a bound on the gradient.
  return slack_of(form, box) +
         form_tolerance * ((bend * reach + slope) * (reach + 8) + bend * reach + std::fabs(c[Form::one]));
}

std::uint32_t negative_corners(const LocalForm& form, Vector half) {
  const auto& b = form.bend;
  const double even =
      form.value + b[Form::xx] * half.x * half.x + b[Form::yy] * half.y * half.y + b[Form::zz] * half.z * half.z;
  const Vector slope{form.gradient.x * half.x, form.gradient.y * half.y, form.gradient.z * half.z};
  const double xy = b[Form::xy] * half.x * half.y, xz = b[Form::xz] * half.x * half.z,
               yz = b[Form::yz] * half.y * half.z;
  std::uint32_t negative = 0;
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    const double x = corner & 1 ? 1 : -1, y = corner & 2 ? 1 : -1, z = corner & 4 ? 1 : -1;
    const double value = even + x * slope.x + y * slope.y + z * slope.z + x * y * xy + x * z * xz + y * z * yz;
    negative |= (value < 0 ? 1U : 0U) << corner;
  }
  return negative;
}

Sides sides_of(const LocalForm& form, Vector half) {
  const double sign = form.value > 0 ? 1 : -1;
  const double least = sign * form.value;
  if (!(least > form.slack) || !(least - rise(form, -sign, half) > form.slack)) return Sides::both;
  return sign > 0 ? Sides::positive : Sides::negative;
}

Sides sides_within(const CellForm& form, const CellBox& box) {
  CSGCAST_PRECONDITION(is_finite(box.lower) && is_finite(box.upper));
  return sides_of(local_form(form, box), 0.5 * (box.upper - box.lower));
}

Sides sides_by_form(const Surface& surface, const Frame& /*frame*/, const CellBox& box) {
  return surface.in_range ? sides_within({surface.local, surface.center}, box) : Sides::both;
}

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
      // The form is least extreme at the finite end. If it grows without bound along one axis and falls along another,
      // it has both signs.
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

}  // namespace csgcast::detail
