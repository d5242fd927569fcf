// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// A solid above which there are only unions. It has the leaves [first_leaf, leaf_end).
struct Body {
  NodeId node;
  PartId part;  ///< not valid outside every part
  LookId look;  ///< the look of its first leaf that nothing subtracts; without such a leaf, the look of the statements
                ///< above it
  std::uint32_t first_leaf;
  std::uint32_t leaf_end;
  bool transmits;  ///< true if some leaf that nothing subtracts lets light through
};

/// Makes the body of a node whose leaves are those from `first_leaf` to the last one in the tables. `look` is the look
/// of the statements above it.
Body body_of(const SceneTables& tables, NodeId node, PartId part, LookId look, std::uint32_t first_leaf);

/// Fills in the tables above the bodies: the regions, the root, the nodes of the parts, the layers, and the region of
/// each leaf. The bodies must be in file order.
void gather_regions(std::vector<Body> bodies, SceneTables& tables);

}  // namespace csgcast::detail
