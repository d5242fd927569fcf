// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "tests/bench/peers/part_tree.h"

namespace csgcast::bench {

/// Which points of a ray are inside a tree of parts, as the ray enters and leaves the parts one after the other. A
/// change climbs the tree only as far as it makes a difference.
class TreeState {
 public:
  explicit TreeState(const PartTree& tree) : links_(tree.parts.size()) {
    std::vector<Link> links(tree.nodes.size());
    gates_.push_back({1, 1, {}});  // above the root: what it counts is whether the root is inside
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
      const PartNode& node = tree.nodes[i];
      if (i + 1 == tree.nodes.size()) links[i] = {0, 1};
      if (node.op == PartNode::Op::part) {
        links_[node.part] = links[i];
        continue;
      }
      const auto gate = static_cast<std::uint32_t>(gates_.size());
      const auto count = static_cast<std::int32_t>(node.children.size());
      // A gate is open if none of what it needs is missing. A union misses one child, an intersection all; a
      // difference has what it subtracts as long as the ray is outside of it.
      const bool is_union = node.op == PartNode::Op::unite, is_difference = node.op == PartNode::Op::subtract;
      gates_.push_back({is_union || is_difference ? 1 : count, 0, links[i]});
      for (const std::uint32_t child : node.children)
        links[child] = {gate, is_difference && child != node.children.front() ? -1 : 1};
    }
    for (Gate& gate : gates_) gate.missing_at_first = gate.missing;
  }

  /// Outside of all parts.
  void reset() {
    for (Gate& gate : gates_) gate.missing = gate.missing_at_first;
  }

  bool inside() const { return gates_[0].missing <= 0; }

  /// The ray enters a part (change = 1) or leaves it (-1).
  void pass(std::uint32_t part, std::int32_t change) {
    Link link = links_[part];
    while (true) {
      Gate& gate = gates_[link.gate];
      const bool was_open = gate.missing <= 0;
      gate.missing -= change * link.sign;
      const bool is_open = gate.missing <= 0;
      if (is_open == was_open || link.gate == 0) return;
      change = is_open ? 1 : -1;
      link = gate.up;
    }
  }

 private:
  struct Link {
    std::uint32_t gate = 0;
    std::int32_t sign = 1;  ///< -1: what is inside the child is outside of the parent
  };
  struct Gate {
    std::int32_t missing = 0;
    std::int32_t missing_at_first = 0;
    Link up;
  };

  std::vector<Link> links_;  ///< of the parts
  std::vector<Gate> gates_;
};

/// Where a ray enters or leaves a part.
struct Event {
  double t = 0;
  std::uint32_t part = 0;
  std::int32_t change = 0;  ///< 1: enters, -1: leaves
};

/// By t. Most rays meet few parts, and the hierarchy finds them nearly in order.
inline void sort_events(std::span<Event> events) {
  constexpr std::size_t few = 32;
  if (events.size() > few) {
    std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.t < b.t; });
    return;
  }
  for (std::size_t i = 1; i < events.size(); ++i) {
    const Event event = events[i];
    std::size_t place = i;
    for (; place > 0 && event.t < events[place - 1].t; --place) events[place] = events[place - 1];
    events[place] = event;
  }
}

/// Calls visit(t) wherever the ray passes the solid's boundary, in ascending order, until it returns false. Events of
/// one t are passed together, so that faces that come out at the very same double leave no sliver. The state is reset.
template <class Visit>
void for_each_boundary(std::span<const Event> sorted, TreeState& state, const Visit& visit) {
  state.reset();
  bool inside = false;
  for (std::size_t i = 0; i < sorted.size();) {
    const double t = sorted[i].t;
    for (; i < sorted.size() && sorted[i].t == t; ++i) state.pass(sorted[i].part, sorted[i].change);
    if (state.inside() == inside) continue;
    inside = !inside;
    if (!visit(t)) return;
  }
}

}  // namespace csgcast::bench
