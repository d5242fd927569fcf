// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "csg/base/ids.h"
#include "csg/base/vector.h"
#include "raycast/cells/build/cell_ground.h"

namespace csgcast::detail {

struct SectionGround {
  std::shared_ptr<const CellGround> ground;
  bool misses = false;  ///< true if the plane does not meet the node
};

/// A ground for the section of a node with the plane normal . p = distance. It is made from the node's ground. Its axes
/// x and y are in the plane. No surface depends on z, which goes from -1/2 to 1/2. Preconditions: the node is bounded,
/// and the normal is not zero.
SectionGround section_ground(const CellGround& of, NodeId node, Vector normal, double distance);

}  // namespace csgcast::detail
