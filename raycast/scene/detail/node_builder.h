// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// Appends nodes to the tables of a scene. Each node gets the box that holds it, without a margin.
class NodeBuilder {
 public:
  /// The tables must outlive it.
  explicit NodeBuilder(SceneTables& tables) : tables_(tables) {}

  NodeId add_leaf(LeafId leaf, const Box& box);
  /// Adds an operator over nodes that exist already. Without children the node is nothing, or everything. If boxes show
  /// that nothing is left, the node is an empty one.
  NodeId add(Node::Op op, std::span<const NodeId> children);
  /// Adds a union of any number of nodes. Empty nodes are left out, and the union of one node is that node. More than a
  /// few bounded nodes become a hierarchy of unions, so that boxes cull. Order and grouping do not change a union.
  NodeId add_union(std::vector<NodeId> children);
  /// Adds the difference: the first node less all others. Precondition: there are at least two.
  NodeId add_difference(std::span<const NodeId> children);

 private:
  // A child of a wide union with the middle of its box. Both are stored together, because the children are sorted.
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
/// the greatest distance by which welding moved a face.
void widen_boxes(std::span<Node> nodes, double moved);

}  // namespace csgcast::detail
