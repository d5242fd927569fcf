// SPDX-License-Identifier: MIT
#include "raycast/scene/detail/node_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace csgcast::detail {
namespace {

// A union of more children than this is split in two.
constexpr std::size_t widest_union = 4;
// The boxes of nodes are widened by this share of their coordinates.
constexpr double margin = 0x1p-30;
// If welding moved a face, the corners of its leaf moved by at most this many times as much, unless faces that meet
// there are nearly parallel.
constexpr double margin_of_moves = 0x1p10;

double middle(const Box& box, std::size_t axis) { return 0.5 * box.lower[axis] + 0.5 * box.upper[axis]; }

}  // namespace

NodeId NodeBuilder::append(const Node& node) {
  tables_.nodes.push_back(node);
  return NodeId(static_cast<std::uint32_t>(tables_.nodes.size() - 1));
}

NodeId NodeBuilder::add_leaf(LeafId leaf, const Box& box) {
  return append({.op = Node::Op::leaf, .first = leaf.index(), .box = box});
}

Box NodeBuilder::box_of(Node::Op op, std::span<const NodeId> children) const {
  if (op == Node::Op::empty) return {};
  if (op == Node::Op::everything || op == Node::Op::complement) return Box::everything();
  Box box = node(children.front()).box;
  if (op == Node::Op::subtract) return box;
  for (const NodeId child : children.subspan(1)) {
    const Box& other = node(child).box;
    box = op == Node::Op::unite ? hull(box, other) : intersection(box, other);
  }
  return box;
}

NodeId NodeBuilder::add(Node::Op op, std::span<const NodeId> children) {
  const Box box = box_of(op, children);
  const bool empty =
      op == Node::Op::empty || (op != Node::Op::complement && op != Node::Op::everything && box.is_null());
  Node node{.op = empty ? Node::Op::empty : op, .box = box};
  if (!empty) {
    node.first = static_cast<std::uint32_t>(tables_.children.size());
    node.count = static_cast<std::uint32_t>(children.size());
    tables_.children.insert(tables_.children.end(), children.begin(), children.end());
  }
  return append(node);
}

NodeId NodeBuilder::add_difference(std::span<const NodeId> children) {
  std::vector<NodeId> subtrahends(children.begin() + 1, children.end());
  const std::array<NodeId, 2> pair{children.front(), add_union(std::move(subtrahends))};
  return add(Node::Op::subtract, pair);
}

NodeId NodeBuilder::add_union(std::vector<NodeId> children) {
  std::erase_if(children, [&](NodeId child) { return node(child).op == Node::Op::empty; });
  if (children.empty()) return add(Node::Op::empty, {});
  if (children.size() == 1) return children.front();
  const auto unbounded =
      std::partition(children.begin(), children.end(), [&](NodeId child) { return node(child).box.is_finite(); });
  if (unbounded != children.end() && unbounded != children.begin()) {
    std::vector<NodeId> top(unbounded, children.end());
    top.push_back(add_union({children.begin(), unbounded}));
    return add(Node::Op::unite, top);
  }
  if (children.size() <= widest_union || unbounded == children.begin()) return add(Node::Op::unite, children);
  std::vector<UnionChild> hierarchy;
  hierarchy.reserve(children.size());
  for (const NodeId child : children) {
    const Box& box = node(child).box;
    hierarchy.push_back({child, {middle(box, 0), middle(box, 1), middle(box, 2)}});
  }
  return add_hierarchy(hierarchy);
}

std::size_t NodeBuilder::longest_axis(std::span<const UnionChild> children) {
  Point low = children.front().middle, high = low;
  for (const UnionChild& child : children) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], child.middle[axis]);
      high[axis] = std::max(high[axis], child.middle[axis]);
    }
  }
  const Vector extent = high - low;
  if (extent.x >= extent.y && extent.x >= extent.z) return 0;
  return extent.y >= extent.z ? 1 : 2;
}

// Halves the children along the longest axis. The recursion is as deep as the logarithm of their number.
NodeId NodeBuilder::add_hierarchy(std::span<UnionChild> children) {
  if (children.size() <= widest_union) {
    std::array<NodeId, widest_union> nodes;
    std::transform(children.begin(), children.end(), nodes.begin(), [](const UnionChild& child) { return child.node; });
    return add(Node::Op::unite, std::span(nodes).first(children.size()));
  }
  const std::size_t axis = longest_axis(children);
  const std::size_t half = children.size() / 2;
  std::nth_element(children.begin(), children.begin() + static_cast<std::ptrdiff_t>(half), children.end(),
                   [axis](const UnionChild& a, const UnionChild& b) {
                     const double at_a = a.middle[axis], at_b = b.middle[axis];
                     return at_a < at_b || (at_a == at_b && a.node < b.node);
                   });
  const std::array<NodeId, 2> halves{add_hierarchy(children.first(half)), add_hierarchy(children.subspan(half))};
  return add(Node::Op::unite, halves);
}

void widen_boxes(std::span<Node> nodes, double moved) {
  for (Node& node : nodes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double& lower = node.box.lower[axis];
      double& upper = node.box.upper[axis];
      const double low = std::isfinite(lower) ? std::fabs(lower) : 0;
      const double high = std::isfinite(upper) ? std::fabs(upper) : 0;
      const double width = margin * std::fmax(low, high) + margin_of_moves * moved;
      lower -= width;
      upper += width;
    }
  }
}

}  // namespace csgcast::detail
