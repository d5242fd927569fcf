// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "measure/search/redundancy.h"
#include "raycast/cells/pieces.h"

namespace csgcast::detail {

struct Redundancies {
  std::vector<Redundancy> found;
  std::size_t not_asked = 0;  ///< statements among so many others that they were not asked
};

/// The outermost statements that a solid would be the same without, proved one by one, in file order. `whole`: the
/// space of the scene's root. `is_empty(node)` is true if a node is known to hold nothing. `tell(share done)` may
/// throw.
Redundancies redundancies(const Space& whole, const std::function<bool(NodeId)>& is_empty,
                          const std::function<void(double)>& tell);

}  // namespace csgcast::detail
