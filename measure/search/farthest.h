// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "csg/base/truth_table.h"
#include "csg/base/vector.h"
#include "measure/sheet/linear_cut.h"

namespace csgcast::detail {

/// The farthest corner, in some direction, of a part that planes cut out of a box.
struct Corner {
  double reach = 0;  ///< direction . place
  Vector place;
  Vector inner;  ///< a point inside the same tetrahedron, not on its faces
};

/// Examines the points of a box about the origin that are inside by the signs of linear forms. Each form may be off by
/// its entry in `off`. No such point is farther than the result. Returns nothing if there is no such point, or none
/// beyond `least`.
std::optional<Corner> farthest_corner(std::span<const LinearForm> forms, std::span<const double> off,
                                      const TruthTable& table, Vector half, Vector direction, double least);

}  // namespace csgcast::detail
