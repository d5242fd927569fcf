// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "csg/exact/affine.h"
#include "csg/exact/quadric_form.h"

namespace csgcast::detail {

using RoundedCoefficients = std::array<double, QuadricForm::term_count>;

/// Scales a form by a power of two, so that its largest coefficient is in [1/2, 1), and rounds it to nearest. If
/// `left_over` is not null, it gets the rounded difference. If `all_told` is not null, it tells if the sum of both is
/// exactly the scaled form. Returns false if a coefficient that is not zero came out as zero or subnormal; then the
/// relative bound is void.
bool round_scaled(const QuadricForm& form, RoundedCoefficients& rounded, RoundedCoefficients* left_over = nullptr,
                  bool* all_told = nullptr);

/// The exact form of f in other coordinates q: f(origin + 2^exponent q).
QuadricForm in_coordinates(const QuadricForm& f, const ExactPoint& origin, int exponent);

}  // namespace csgcast::detail
