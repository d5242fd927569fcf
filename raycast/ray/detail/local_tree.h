// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "csg/base/truth.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// The part of a scene's tree that matters near one place. Nodes whose boxes do not hold the place count as empty. This
/// part is small, and can be evaluated many times.
class LocalTree {
 public:
  /// Takes the part of the tree below `root`. `near(box)` tells if the place may be in a box of the scene.
  template <class Near>
  void build(const Scene& scene, NodeId root, Near&& near) {
    clear();
    open(scene, root, near);
    while (!open_nodes_.empty()) {
      OpenNode& top = open_nodes_.back();
      const std::span<const NodeId> children = scene.children(*top.node);
      if (top.next < children.size()) {
        open(scene, children[top.next++], near);
      } else {
        close();
      }
    }
  }

  /// The leaves near the place. A leaf's index in this list is its slot.
  std::span<const LeafId> leaves() const { return leaves_; }
  /// Evaluates the tree: the root's truth, given that of each leaf by slot.
  Truth evaluate(std::span<const Truth> leaf_truth);
  /// Changes one leaf's truth in the last evaluation, follows the change towards the root and returns the root's truth.
  /// The cost is at most of the order of the leaf's depth. Precondition: evaluate() was called.
  Truth update(std::size_t slot, Truth leaf_truth);
  /// The first leaf in file order that holds the place and that no operator subtracts or leaves out, by the last
  /// evaluation or update. It is not valid if there is none.
  LeafId first_holding_leaf();

 private:
  struct Entry {
    Node::Op op;
    std::uint32_t first = 0;  // the index of its first child in children_; for a leaf, its slot
    std::uint32_t count = 0;
  };
  // A node of the scene's tree whose children are being added.
  struct OpenNode {
    const Node* node;
    std::uint32_t next;   // the child to add next
    std::size_t pending;  // the index of its first child's entry in pending_
  };

  template <class Near>
  void open(const Scene& scene, NodeId id, Near&& near) {
    const Node& node = scene.node(id);
    const bool constant = node.op == Node::Op::empty || node.op == Node::Op::everything;
    if (constant) return add({node.op, 0, 0});
    if (!near(node.box)) return add({Node::Op::empty, 0, 0});
    if (node.op == Node::Op::leaf) return add_leaf(LeafId(node.first));
    open_nodes_.push_back({&node, 0, pending_.size()});
  }
  void clear();
  void close();
  void add(Entry entry);
  void add_leaf(LeafId leaf);
  Truth value_of(const Entry& entry) const;

  std::vector<Entry> entries_;           // children before parents; the root last
  std::vector<std::uint32_t> children_;  // indices of entries
  std::vector<std::uint32_t> parent_;    // by entry; the root is its own parent
  std::vector<LeafId> leaves_;
  std::vector<std::uint32_t> entry_of_;  // by slot
  std::vector<Truth> value_;             // by entry, from the last evaluation
  std::vector<std::uint8_t> active_;     // by entry: 1 if this entry and all entries above it hold the place
  std::vector<OpenNode> open_nodes_;     // a stack, the root first
  std::vector<std::uint32_t> pending_;   // entries that no parent has taken yet
};

}  // namespace csgcast::detail
