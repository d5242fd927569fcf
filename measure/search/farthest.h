// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "csg/base/truth_table.h"
#include "csg/base/vector.h"
#include "measure/sheet/linear_cut.h"

namespace csgcast::detail {

/// The farthest corner, in some direction, of what planes cut out of a box.
struct Corner {
  double reach = 0;  ///< direction . place
  Vector place;
  Vector inner;  ///< a point of the same tetrahedron, off its faces
};

/// Of the points of a box about the origin that are inside by the signs of forms, which may be off by as much as `off`
/// says: no such point is farther. Nothing if there is none, or none beyond `least`.
std::optional<Corner> farthest_corner(std::span<const LinearForm> forms, std::span<const double> off,
                                      const TruthTable& table, Vector half, Vector direction, double least);

}  // namespace csgcast::detail
