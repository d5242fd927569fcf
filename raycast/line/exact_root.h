// SPDX-License-Identifier: MIT
#pragma once

#include <compare>

#include "csg/exact/dyadic.h"

namespace csgcast::detail {

/// The exact place of a crossing: t = (p + s sqrt(d)) / q. Here p, q and d >= 0 are integers times powers of two, and s
/// is -1, 0 or 1. Roots of surfaces of all kinds can be compared with each other.
struct ExactRoot {
  Dyadic p;
  Dyadic q;
  Dyadic d;
  int s = 0;

  explicit ExactRoot(const Dyadic& value) : p(value), q(1.0) {}
  /// Precondition: the divisor is not zero.
  static ExactRoot quotient(const Dyadic& dividend, const Dyadic& divisor);
  /// The lower root (number 0) or the upper root (number 1) of a t² + b t + c. If a is zero, this is the only root of b
  /// t + c. If there are no roots, d < 0. Precondition: the polynomial is not constant.
  static ExactRoot of(const Dyadic& a, const Dyadic& b, const Dyadic& c, unsigned root);
};

std::strong_ordering operator<=>(const ExactRoot& a, const ExactRoot& b);

}  // namespace csgcast::detail
