// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/surface/line_crossings.h"

namespace csgcast::detail {

/// The result without a crossing: the whole line is on one side.
inline LineCrossings none(bool positive) {
  LineCrossings found;
  found.positive_before = positive;
  return found;
}

/// The result with one crossing. The caller still has to set its error.
inline LineCrossings one(double tau, bool positive_before) {
  LineCrossings found = none(positive_before);
  found.few[0] = tau;
  found.count = 1;
  return found;
}

}  // namespace csgcast::detail
