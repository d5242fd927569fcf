// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "raycast/cells/pieces.h"

namespace csgcast::detail {

/// A place in the plane of a section's space.
using Planar = std::array<double, 2>;

/// A run of a surface's curve along which the value changes, the inside on its left, in the coordinates of the space.
struct Arc {
  Planar from{};
  Planar middle{};
  Planar to{};
  std::uint32_t surface = 0;
};

/// All that is found of a section's boundary: arcs, and the small boxes around corners in which curves were not told
/// apart.
struct ArcTrace {
  std::vector<Arc> arcs;
  std::vector<CellBox> corners;
  double displaced = 0;  ///< how far curves may be from where they were found
};

/// `look_up` is called now and then; what it throws ends the work. Precondition: the space is that of a section, and
/// bounded.
ArcTrace trace_arcs(const Space& space, std::size_t most_pieces, const std::function<void()>& look_up);

/// Joins arcs whose ends meet, or lie at the same corner, to loops; arcs of one surface that follow each other become
/// one, but no loop has a single arc.
struct JoinedArcs {
  std::vector<std::vector<Arc>> loops;
  bool is_closed = true;     ///< false: some arc has no successor
  double widest_corner = 0;  ///< across the boxes and ends that were taken for one corner
};
JoinedArcs join_arcs(const ArcTrace& trace);

}  // namespace csgcast::detail
