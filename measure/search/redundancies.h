// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "measure/search/redundancy.h"
#include "raycast/cells/pieces.h"

namespace csgcast::detail {

struct Redundancies {
  std::vector<Redundancy> found;
  std::size_t not_asked = 0;  ///< the number of statements that were not tested, because they are among too many others
};

/// Finds the outermost statements without which a solid would be the same. Each is proved; they are in file order.
/// `whole` is the space of the scene's root. `is_empty(node)` is true if a node is known to hold nothing. `tell(share
/// done)` may throw.
Redundancies redundancies(const Space& whole, const std::function<bool(NodeId)>& is_empty,
                          const std::function<void(double)>& tell);

}  // namespace csgcast::detail
