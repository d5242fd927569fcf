// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/line/interval_list.h"
#include "raycast/scene/scene.h"
#include "raycast/surface/line_crossings.h"

namespace csgcast::detail {

/// Fills a list with the runs of a line that are in a half-space. `line` is a LeafLine (leaf_function.h), or a type
/// with the same functions.
template <class Line>
void half_space_runs(Line& line, const HalfSpace& half_space, IntervalList& list) {
  const LineCrossings& found = line.found(half_space.surface);
  list.clear();
  Crossing from = line_start();
  for (unsigned n = 0; n <= found.count; ++n) {
    const Crossing to = n < found.count ? line.crossing(half_space.surface, static_cast<std::uint8_t>(n)) : line_end();
    if (found.positive_after(n) == (half_space.sense == Sense::positive)) list.push_back({from, to});
    from = to;
  }
}

}  // namespace csgcast::detail
