// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "raycast/scene/detail/scene_compiler.h"

// What the compiler does above the bodies, the solids at union level: unions as hierarchies of boxes, regions, parts,
// layers.

namespace csgcast {
namespace {

// Unions of more children than this are split in two.
constexpr std::size_t widest_union = 4;
// Culling must not depend on the last bits of slab tests: boxes of nodes are widened by this share of their
// coordinates.
constexpr double margin = 0x1p-30;
// Where welding moved a face by so much its leaf's corners moved by at most this many times that, unless the faces that
// meet there are nearly parallel.
constexpr double margin_of_moves = 0x1p10;

bool is_bounded(const Box& box) { return box.is_finite(); }

double middle(const Box& box, std::size_t axis) { return 0.5 * box.lower[axis] + 0.5 * box.upper[axis]; }

}  // namespace

// A union is the same in any order and grouping: wide ones become a hierarchy, so that boxes cull.
NodeId SceneCompiler::add_union(std::vector<NodeId> children) {
  std::erase_if(children, [&](NodeId child) { return scene_.node(child).op == Node::Op::empty; });
  if (children.empty()) return add_node(Node::Op::empty, {});
  if (children.size() == 1) return children.front();
  const auto unbounded = std::partition(children.begin(), children.end(),
                                        [&](NodeId child) { return is_bounded(scene_.node(child).box); });
  if (unbounded != children.end() && unbounded != children.begin()) {
    std::vector<NodeId> top(unbounded, children.end());
    top.push_back(add_union({children.begin(), unbounded}));
    return add_node(Node::Op::unite, top);
  }
  if (children.size() <= widest_union || unbounded == children.begin()) return add_node(Node::Op::unite, children);
  std::vector<UnionChild> hierarchy;
  hierarchy.reserve(children.size());
  for (const NodeId child : children) {
    const Box& box = scene_.node(child).box;
    hierarchy.push_back({child, {middle(box, 0), middle(box, 1), middle(box, 2)}});
  }
  return add_hierarchy(hierarchy);
}

std::size_t SceneCompiler::longest_axis(std::span<const UnionChild> children) {
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

// Halved along the longest axis. Recursive, to the logarithm of the number of children.
NodeId SceneCompiler::add_hierarchy(std::span<UnionChild> children) {
  if (children.size() <= widest_union) {
    std::array<NodeId, widest_union> nodes;
    std::transform(children.begin(), children.end(), nodes.begin(), [](const UnionChild& child) { return child.node; });
    return add_node(Node::Op::unite, std::span(nodes).first(children.size()));
  }
  const std::size_t axis = longest_axis(children);
  const std::size_t half = children.size() / 2;
  std::nth_element(children.begin(), children.begin() + static_cast<std::ptrdiff_t>(half), children.end(),
                   [axis](const UnionChild& a, const UnionChild& b) {
                     const double at_a = a.middle[axis], at_b = b.middle[axis];
                     return at_a < at_b || (at_a == at_b && a.node < b.node);
                   });
  const std::array<NodeId, 2> halves{add_hierarchy(children.first(half)), add_hierarchy(children.subspan(half))};
  return add_node(Node::Op::unite, halves);
}

void SceneCompiler::add_body(NodeId node, const Context& context, std::uint32_t first_leaf) {
  Body body{node, context.part, context.look, first_leaf, static_cast<std::uint32_t>(scene_.leaves_.size()), false};
  bool first = true;
  for (std::uint32_t i = body.first_leaf; i < body.leaf_end; ++i) {
    const Leaf& leaf = scene_.leaves_[i];
    // Leaves that something subtracts hold nothing: no medium is theirs.
    if (leaf.holds_nothing) continue;
    if (first) body.look = leaf.look;
    first = false;
    body.transmits = body.transmits || scene_.look(leaf.look).transmits();
  }
  bodies_.push_back(body);
}

void SceneCompiler::gather_regions() {
  std::vector<NodeId> regions;
  for (std::size_t begin = 0; begin < bodies_.size();) {
    const Body& first = bodies_[begin];
    std::size_t end = begin;
    Region region{{}, first.part, first.look, false};
    std::vector<NodeId> nodes;
    for (; end < bodies_.size() && bodies_[end].part == first.part && bodies_[end].look == first.look; ++end) {
      nodes.push_back(bodies_[end].node);
      region.transmits = region.transmits || bodies_[end].transmits;
    }
    region.node = add_union(std::move(nodes));
    for (std::uint32_t i = first.first_leaf; i < bodies_[end - 1].leaf_end; ++i) {
      scene_.leaves_[i].region = RegionId(static_cast<std::uint32_t>(scene_.regions_.size()));
    }
    regions.push_back(region.node);
    scene_.regions_.push_back(region);
    begin = end;
  }
  scene_.root_ = add_union(std::move(regions));
  gather_parts();
  gather_layers();
}

void SceneCompiler::gather_parts() {
  std::vector<std::vector<NodeId>> of_part(scene_.parts_.size());
  for (const Region& region : scene_.regions_) {
    if (region.part.valid()) of_part[region.part.index()].push_back(region.node);
  }
  for (std::size_t i = 0; i < of_part.size(); ++i) scene_.parts_[i].node = add_union(std::move(of_part[i]));
}

void SceneCompiler::gather_layers() {
  const auto& regions = scene_.regions_;
  if (std::none_of(regions.begin(), regions.end(), [](const Region& region) { return region.transmits; })) return;
  std::vector<NodeId> opaque;
  const auto close_opaque = [&] {
    if (!opaque.empty()) scene_.layers_.push_back({add_union(std::move(opaque)), {}});
    opaque.clear();
  };
  for (std::uint32_t i = 0; i < regions.size(); ++i) {
    if (!regions[i].transmits) {
      opaque.push_back(regions[i].node);
      continue;
    }
    close_opaque();
    scene_.layers_.push_back({regions[i].node, RegionId(i)});
  }
  close_opaque();
}

void SceneCompiler::widen_boxes() {
  const double moved = margin_of_moves * scene_.weld_report_.widest;
  for (Node& node : scene_.nodes_) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double& lower = node.box.lower[axis];
      double& upper = node.box.upper[axis];
      const double low = std::isfinite(lower) ? std::fabs(lower) : 0;
      const double high = std::isfinite(upper) ? std::fabs(upper) : 0;
      lower -= margin * std::fmax(low, high) + moved;
      upper += margin * std::fmax(low, high) + moved;
    }
  }
}

}  // namespace csgcast
