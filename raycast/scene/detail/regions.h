// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// A solid above which there are only unions. Its leaves are [first_leaf, leaf_end).
struct Body {
  NodeId node;
  PartId part;  ///< not valid outside every part
  LookId look;  ///< that of its first leaf that nothing subtracts; without one, that of the statements above it
  std::uint32_t first_leaf;
  std::uint32_t leaf_end;
  bool transmits;  ///< some leaf that nothing subtracts lets light through
};

/// The body of a node whose leaves are those from `first_leaf` to the last one that the tables have. `look` is that of
/// the statements above it.
Body body_of(const SceneTables& tables, NodeId node, PartId part, LookId look, std::uint32_t first_leaf);

/// Fills in what the tables have above the bodies, which are in file order: the regions, the root, the nodes of the
/// parts, the layers, and the region of each leaf.
void gather_regions(std::vector<Body> bodies, SceneTables& tables);

}  // namespace csgcast::detail
