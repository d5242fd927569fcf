// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace csgcast {

/// Walks trees from their roots down and back up in file order. It does not recurse, because trees may be a million
/// deep. It keeps its memory. `State` is the state of a node that is kept while its children are visited.
template <class Node, class State>
class TreeWalk {
 public:
  /// Visits the roots and returns `top`, the state that stands above them.
  ///
  /// `enter(node, above)` is called before a node's children, where `above` is the state of its parent. It returns the
  /// node's own state, or nothing if the children should not be visited. `children(node)` is then the span of its
  /// children. `leave(node, state, above)` is called after them with the state (State&&) that enter returned.
  template <class Enter, class Children, class Leave>
  State run(std::span<Node> roots, State top, Enter&& enter, Children&& children, Leave&& leave) {
    open_.clear();
    open_.push_back({nullptr, roots, std::move(top)});
    for (;;) {
      if (Open& last = open_.back(); !last.to_come.empty()) {
        Node& node = last.to_come.front();
        last.to_come = last.to_come.subspan(1);
        if (std::optional<State> state = enter(node, last.state)) {
          open_.push_back({&node, children(node), std::move(*state)});
        }
        continue;
      }
      Open done = std::move(open_.back());
      open_.pop_back();
      if (open_.empty()) return std::move(done.state);
      leave(*done.node, std::move(done.state), open_.back().state);
    }
  }

 private:
  struct Open {
    Node* node;  // null above the roots
    std::span<Node> to_come;
    State state;
  };

  std::vector<Open> open_;
};

}  // namespace csgcast
