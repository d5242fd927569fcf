// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/line/twofold.h"

namespace csgcast::detail {

/// A crossing's tau in twofold arithmetic with a bound on its error.
struct TwofoldRoot {
  Twofold tau;
  double error;
};

/// The sign of a - b if it is certain, else 0.
int certain_order(const TwofoldRoot& a, const TwofoldRoot& b);

}  // namespace csgcast::detail
