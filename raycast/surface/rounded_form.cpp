// SPDX-License-Identifier: MIT
#include "raycast/surface/rounded_form.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace csgcast::detail {
namespace {

using Form = QuadricForm;

}  // namespace

bool round_scaled(const QuadricForm& form, RoundedCoefficients& rounded, RoundedCoefficients* left_over,
                  bool* all_told) {
  std::int64_t scale = std::numeric_limits<std::int64_t>::min();
  for (const Dyadic& c : form.coefficient) {
    if (!c.is_zero()) scale = std::max(scale, c.magnitude());
  }
  bool in_range = true;
  if (all_told != nullptr) *all_told = left_over != nullptr;
  for (std::size_t i = 0; i < rounded.size(); ++i) {
    if (form.coefficient[i].is_zero()) {
      rounded[i] = 0;
      if (left_over != nullptr) (*left_over)[i] = 0;
      continue;
    }
    rounded[i] = form.coefficient[i].nearest(-scale);
    if (left_over != nullptr) {
      const Dyadic rest = form.coefficient[i] - Dyadic(rounded[i]).scaled(scale);
      (*left_over)[i] = rest.nearest(-scale);
      if (all_told != nullptr) *all_told = *all_told && Dyadic((*left_over)[i]).scaled(scale) == rest;
    }
    in_range = in_range && std::isnormal(rounded[i]);
  }
  return in_range;
}

QuadricForm in_coordinates(const QuadricForm& f, const ExactPoint& origin, int exponent) {
  const auto& [x, y, z] = origin;
  const auto& c = f.coefficient;
  const Dyadic two(2.0);
  Form g = f;
  g.coefficient[Form::x] += two * c[Form::xx] * x + c[Form::xy] * y + c[Form::xz] * z;
  g.coefficient[Form::y] += two * c[Form::yy] * y + c[Form::xy] * x + c[Form::yz] * z;
  g.coefficient[Form::z] += two * c[Form::zz] * z + c[Form::xz] * x + c[Form::yz] * y;
  g.coefficient[Form::one] += (c[Form::xx] * x + c[Form::xy] * y + c[Form::xz] * z + c[Form::x]) * x +
                              (c[Form::yy] * y + c[Form::yz] * z + c[Form::y]) * y + (c[Form::zz] * z + c[Form::z]) * z;
  for (std::size_t i = 0; i < Form::one; ++i) {
    g.coefficient[i] = g.coefficient[i].scaled(i < Form::x ? 2 * std::int64_t{exponent} : exponent);
  }
  return g;
}

}  // namespace csgcast::detail
