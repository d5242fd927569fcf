// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// False, true, or not known (Kleene's logic).
enum class Truth : std::uint8_t { no, unknown, yes };

constexpr Truth truth(bool value) { return value ? Truth::yes : Truth::no; }

/// The part of a scene's tree that matters near one place: nodes whose boxes are away from it count as empty. Small,
/// and evaluated many times.
class LocalTree {
 public:
  /// `near(box)`: whether the place may be in the box.
  template <class Near>
  void build(const Scene& scene, NodeId root, Near&& near) {
    clear();
    open(scene, root, near);
    while (!frames_.empty()) {
      Frame& frame = frames_.back();
      const std::span<const NodeId> children = scene.children(*frame.node);
      if (frame.next < children.size()) {
        open(scene, children[frame.next++], near);
      } else {
        close();
      }
    }
  }

  /// The leaves near the place; a leaf's index here is its slot.
  std::span<const LeafId> leaves() const { return leaves_; }
  /// The root's truth, given that of each leaf (by slot).
  Truth evaluate(std::span<const Truth> leaf_truth);
  /// Changes one leaf's truth since the last evaluation and follows it to the root: its truth now. Costs the leaf's
  /// depth at most.
  Truth update(std::size_t slot, Truth leaf_truth);
  /// Of the leaves that hold the place and that no operator subtracts or leaves out, the first in file order. Looks at
  /// the last evaluation.
  LeafId first_holding_leaf();

 private:
  struct Entry {
    Node::Op op;
    std::uint32_t first = 0;  // of its children in children_, or a leaf's slot
    std::uint32_t count = 0;
  };
  struct Frame {
    const Node* node;
    std::uint32_t next;
    std::size_t pending;  // where its children's entries start in pending_
  };

  template <class Near>
  void open(const Scene& scene, NodeId id, Near&& near) {
    const Node& node = scene.node(id);
    const bool constant = node.op == Node::Op::empty || node.op == Node::Op::everything;
    if (constant) return add({node.op, 0, 0});
    if (!near(node.box)) return add({Node::Op::empty, 0, 0});
    if (node.op == Node::Op::leaf) return add_leaf(LeafId(node.first));
    frames_.push_back({&node, 0, pending_.size()});
  }
  void clear();
  void close();
  void add(Entry entry);
  void add_leaf(LeafId leaf);
  Truth value_of(const Entry& entry) const;

  std::vector<Entry> entries_;           // children before parents; the root last
  std::vector<std::uint32_t> children_;  // indices of entries
  std::vector<std::uint32_t> parent_;    // by entry; the root's is its own
  std::vector<LeafId> leaves_;
  std::vector<std::uint32_t> entry_of_;  // by slot
  std::vector<Truth> value_;
  std::vector<std::uint8_t> active_;
  std::vector<Frame> frames_;
  std::vector<std::uint32_t> pending_;
};

}  // namespace csgcast::detail
