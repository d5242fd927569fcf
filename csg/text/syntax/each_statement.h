// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "csg/text/syntax/syntax.h"

namespace csgcast::text {

/// Calls visit(statement) for each statement and those in its blocks, in file order, without recursion. `AnyNode` is
/// Node or const Node; visit must not change which statements there are.
template <class AnyNode, class Visit>
void each_statement(std::span<AnyNode> statements, Visit&& visit) {
  std::vector<std::span<AnyNode>> open{statements};
  while (!open.empty()) {
    if (open.back().empty()) {
      open.pop_back();
      continue;
    }
    AnyNode& node = open.back().front();
    open.back() = open.back().subspan(1);
    visit(node);
    open.push_back(std::span<AnyNode>(node.children));
  }
}

}  // namespace csgcast::text
