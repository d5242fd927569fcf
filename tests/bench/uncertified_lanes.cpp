// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, by the code that it includes.
#include "tests/bench/uncertified_lanes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <vector>

namespace csgcast::uncertified {
using namespace csgcast::detail;
}

// The lanes once more, under another name.
#define CSGCAST_UNCERTIFIED_LANES
#define detail uncertified
#include "raycast/packets/detail/lanes.cpp"
#undef detail

#if HWY_ONCE
namespace csgcast::bench {

const detail::LaneCode& uncertified_lanes() { return uncertified::lane_codes().front(); }

}  // namespace csgcast::bench
#endif
