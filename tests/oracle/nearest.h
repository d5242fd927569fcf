// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "tests/oracle/rational.h"

namespace csgcast::oracle {

/// The place halfway from a double to the next one in a direction (an infinity); beyond the last double, where the next
/// one would be.
Rational halfway_to_next(double t, double direction);
/// Whether the last bit is zero.
bool is_even(double t);

/// Whether t is the nearest double to an exact number, ties to even; infinite beyond the doubles. `compare(x)` is the
/// sign of the exact number less a Rational x.
template <class Compare>
bool is_nearest(double t, Compare&& compare) {
  constexpr double most = std::numeric_limits<double>::max();
  constexpr double inf = std::numeric_limits<double>::infinity();
  if (t == inf) return compare(halfway_to_next(most, inf)) >= 0;
  if (t == -inf) return compare(halfway_to_next(-most, -inf)) <= 0;
  const int below = compare(halfway_to_next(t, -inf));
  const int above = compare(halfway_to_next(t, inf));
  return (below > 0 && above < 0) || ((below == 0 || above == 0) && is_even(t));
}

}  // namespace csgcast::oracle
