// SPDX-License-Identifier: MIT
#include <utility>

#include "tests/oracle/quadrics/formula.h"
#include "tests/support/rebuilt.h"

namespace csgcast::oracle::quadrics {
Solid with_numbered_leaves(const Solid& solid) {
  struct Frame {
    Solid solid;
    std::vector<Solid> done;
  };
  std::vector<Frame> open{{solid, {}}};
  int leaves = 0;
  for (;;) {
    Frame& top = open.back();
    if (top.done.size() < top.solid.children().size()) {
      open.push_back({top.solid.children()[top.done.size()], {}});
      continue;
    }
    const bool is_leaf = top.solid.kind() == Solid::Kind::leaf;
    Solid finished = is_leaf ? top.solid.at({"", ++leaves, 1}) : test::rebuilt(top.solid, std::move(top.done));
    open.pop_back();
    if (open.empty()) return finished;
    open.back().done.push_back(std::move(finished));
  }
}

}  // namespace csgcast::oracle::quadrics
