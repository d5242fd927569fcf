// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "csg/exact/affine.h"
#include "csg/exact/quadric_form.h"

namespace csgcast::detail {

using RoundedCoefficients = std::array<double, QuadricForm::term_count>;

/// The form times a power of two, rounded to nearest, with the largest coefficient in [1/2, 1); what that leaves over,
/// rounded, if asked for. False if a coefficient that is not zero came out as zero or subnormal, which would void the
/// relative bound. `all_told` tells whether both together are the form exactly.
bool round_scaled(const QuadricForm& form, RoundedCoefficients& rounded, RoundedCoefficients* left_over = nullptr,
                  bool* all_told = nullptr);

/// q -> f(origin + 2^exponent q).
QuadricForm in_coordinates(const QuadricForm& f, const ExactPoint& origin, int exponent);

}  // namespace csgcast::detail
