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

/// A run of a surface's curve along which the value changes, in the coordinates of the space. The inside is on its
/// left.
struct Arc {
  Planar from{};
  Planar middle{};
  Planar to{};
  std::uint32_t surface = 0;
};

/// The result of tracing a section's boundary: the arcs, and the small boxes around corners in which curves were not
/// separated.
struct ArcTrace {
  std::vector<Arc> arcs;
  std::vector<CellBox> corners;
  double displaced = 0;  ///< bound on the distance of curves from where they were found
};

/// `look_up` is called now and then; if it throws, the work ends. Preconditions: the space is that of a section, and it
/// is bounded.
ArcTrace trace_arcs(const Space& space, std::size_t most_pieces, const std::function<void()>& look_up);

/// Joins arcs to loops, if their ends meet or lie at the same corner. Consecutive arcs of the same surface become one
/// arc, but no loop has only a single arc.
struct JoinedArcs {
  std::vector<std::vector<Arc>> loops;
  bool is_closed = true;     ///< false if some arc has no successor
  double widest_corner = 0;  ///< the largest size of boxes and ends that were treated as one corner
};
JoinedArcs join_arcs(const ArcTrace& trace);

}  // namespace csgcast::detail
