// SPDX-License-Identifier: MIT
#include "raycast/line/twofold_root.h"

#include <cmath>

namespace csgcast::detail {

int certain_order(const TwofoldRoot& a, const TwofoldRoot& b) {
  const Twofold gap = a.tau + -b.tau;
  if (!(std::fabs(gap.high) > 2 * (a.error + b.error))) return 0;
  return gap.high < 0 ? -1 : 1;
}

}  // namespace csgcast::detail
