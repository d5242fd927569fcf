// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/packets/detail/lanes.h"

namespace csgcast::bench {

/// The best lanes of this machine without certificates: the same code without bounds, flags and the search for ties.
const detail::LaneCode& uncertified_lanes();

}  // namespace csgcast::bench
