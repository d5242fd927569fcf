// SPDX-License-Identifier: MIT
#pragma once

#include "csg/exact/dyadic.h"

// Division and square root of exact numbers, rounded in a given direction with a relative error below 2^-128. The
// result is exact if it is a dyadic number of at most 128 bits.

namespace csgcast::detail {

enum class Toward { down, up };  ///< towards minus or plus infinity

/// Precondition: divisor is not zero.
Dyadic quotient(const Dyadic& dividend, const Dyadic& divisor, Toward toward);
/// Precondition: value >= 0.
Dyadic square_root(const Dyadic& value, Toward toward);

}  // namespace csgcast::detail
