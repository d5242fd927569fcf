// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "csg/base/ids.h"
#include "csg/base/vector.h"
#include "raycast/cells/build/cell_builder.h"

namespace csgcast::detail {

struct SectionGround {
  std::shared_ptr<const CellGround> ground;
  bool misses = false;  ///< the plane has nothing of the node
};

/// The plane normal . p = distance as a ground of its own, of height 1: no surface depends on z. Precondition: the node
/// is bounded, the normal not zero.
SectionGround section_ground(const CellGround& of, NodeId node, Vector normal, double distance);

}  // namespace csgcast::detail
