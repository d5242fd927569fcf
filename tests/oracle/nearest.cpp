// SPDX-License-Identifier: MIT
#include "tests/oracle/nearest.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace csgcast::oracle {

Rational halfway_to_next(double t, double direction) {
  const double next = std::nextafter(t, direction);
  const Rational end =
      std::isinf(next) ? Rational(2 * Rational(t) - Rational(std::nextafter(t, -direction))) : Rational(next);
  return Rational((Rational(t) + end) / 2);
}

bool is_even(double t) { return (std::bit_cast<std::uint64_t>(t) & 1) == 0; }

}  // namespace csgcast::oracle
