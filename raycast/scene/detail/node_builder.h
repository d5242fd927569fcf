// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// Appends nodes to the tables of a scene, each with the box that holds it, without a margin.
class NodeBuilder {
 public:
  /// The tables must outlive it.
  explicit NodeBuilder(SceneTables& tables) : tables_(tables) {}

  NodeId add_leaf(LeafId leaf, const Box& box);
  /// An operator over nodes that are there already, or nothing or everything without any. Where boxes show that nothing
  /// is left, the node is an empty one.
  NodeId add(Node::Op op, std::span<const NodeId> children);
  /// A union of any number of nodes. Empty ones are left out; of one node alone it is that node. More than a few
  /// bounded ones become a hierarchy of unions, so that boxes cull: a union is the same in any order and grouping.
  NodeId add_union(std::vector<NodeId> children);
  /// The first of the nodes less all others. Precondition: there are at least two.
  NodeId add_difference(std::span<const NodeId> children);

 private:
  // A child of a wide union with the middle of its box. These are sorted, so they lie side by side.
  struct UnionChild {
    NodeId node;
    Point middle;
  };

  const Node& node(NodeId id) const { return tables_.nodes[id.index()]; }
  NodeId append(const Node& node);
  Box box_of(Node::Op op, std::span<const NodeId> children) const;
  NodeId add_hierarchy(std::span<UnionChild> children);
  static std::size_t longest_axis(std::span<const UnionChild> children);

  SceneTables& tables_;
};

/// Widens the boxes of nodes by a margin, so that culling does not depend on the last bits of slab tests. `moved` is
/// the farthest that welding moved a face.
void widen_boxes(std::span<Node> nodes, double moved);

}  // namespace csgcast::detail
