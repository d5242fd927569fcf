// SPDX-License-Identifier: MIT
#include <utility>

#include "tests/oracle/quadrics/formula.h"

namespace csgcast::oracle::quadrics {
namespace {

// A node like another over other children.
Solid rebuilt(const Solid& solid, std::vector<Solid> children) {
  switch (solid.kind()) {
    case Solid::Kind::unite:
      return unite(std::move(children));
    case Solid::Kind::intersect:
      return intersect(std::move(children));
    case Solid::Kind::subtract:
      return subtract(std::move(children));
    case Solid::Kind::complement:
      return complement(std::move(children.front()));
    case Solid::Kind::transform:
      return transformed(std::move(children.front()), solid.transform());
    case Solid::Kind::part:
      return named(std::move(children.front()), solid.part());
    case Solid::Kind::look:
      return with_look(std::move(children.front()), solid.look());
    default:
      return solid;
  }
}

}  // namespace

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
    Solid finished = is_leaf ? top.solid.at({"", ++leaves, 1}) : rebuilt(top.solid, std::move(top.done));
    open.pop_back();
    if (open.empty()) return finished;
    open.back().done.push_back(std::move(finished));
  }
}

}  // namespace csgcast::oracle::quadrics
