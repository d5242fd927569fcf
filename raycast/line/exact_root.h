// SPDX-License-Identifier: MIT
#pragma once

#include <compare>

#include "csg/exact/dyadic.h"

namespace csgcast::detail {

/// Where a crossing is, exactly: t = (p + s sqrt(d)) / q with integers (times powers of two) p, q, d >= 0 and s = -1, 0
/// or 1. Roots of surfaces of all kinds compare with each other.
struct ExactRoot {
  Dyadic p;
  Dyadic q;
  Dyadic d;
  int s = 0;

  explicit ExactRoot(const Dyadic& value) : p(value), q(1.0) {}
  /// Precondition: the divisor is not zero.
  static ExactRoot quotient(const Dyadic& dividend, const Dyadic& divisor);
  /// The lower (root 0) or the upper root of a t² + b t + c; of b t + c, if a is zero, its only one. d < 0
  /// if there are none. Precondition: the polynomial is not constant.
  static ExactRoot of(const Dyadic& a, const Dyadic& b, const Dyadic& c, unsigned root);
};

std::strong_ordering operator<=>(const ExactRoot& a, const ExactRoot& b);

}  // namespace csgcast::detail
