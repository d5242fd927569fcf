// SPDX-License-Identifier: MIT
#include "raycast/scene/detail/regions.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "raycast/scene/detail/node_builder.h"

namespace csgcast::detail {
namespace {

// A region is a run of bodies of the same part and the same look.
void add_regions(const std::vector<Body>& bodies, SceneTables& tables, NodeBuilder& nodes) {
  for (std::size_t begin = 0; begin < bodies.size();) {
    const Body& first = bodies[begin];
    std::size_t end = begin;
    Region region{{}, first.part, first.look, false};
    std::vector<NodeId> members;
    for (; end < bodies.size() && bodies[end].part == first.part && bodies[end].look == first.look; ++end) {
      members.push_back(bodies[end].node);
      region.transmits = region.transmits || bodies[end].transmits;
    }
    region.node = nodes.add_union(std::move(members));
    for (std::uint32_t i = first.first_leaf; i < bodies[end - 1].leaf_end; ++i) {
      tables.leaves[i].region = RegionId(static_cast<std::uint32_t>(tables.regions.size()));
    }
    tables.regions.push_back(region);
    begin = end;
  }
}

NodeId add_root(const SceneTables& tables, NodeBuilder& nodes) {
  std::vector<NodeId> regions;
  for (const Region& region : tables.regions) regions.push_back(region.node);
  return nodes.add_union(std::move(regions));
}

// A part is the union of its regions.
void complete_parts(SceneTables& tables, NodeBuilder& nodes) {
  std::vector<std::vector<NodeId>> of_part(tables.parts.size());
  for (const Region& region : tables.regions) {
    if (region.part.valid()) of_part[region.part.index()].push_back(region.node);
  }
  for (std::size_t i = 0; i < of_part.size(); ++i) tables.parts[i].node = nodes.add_union(std::move(of_part[i]));
}

// Each transmitting region is a layer, and so is each run of opaque regions.
void add_layers(SceneTables& tables, NodeBuilder& nodes) {
  const std::vector<Region>& regions = tables.regions;
  if (std::none_of(regions.begin(), regions.end(), [](const Region& region) { return region.transmits; })) return;
  std::vector<NodeId> opaque;
  const auto close_opaque = [&] {
    if (!opaque.empty()) tables.layers.push_back({nodes.add_union(std::move(opaque)), {}});
    opaque.clear();
  };
  for (std::uint32_t i = 0; i < regions.size(); ++i) {
    if (!regions[i].transmits) {
      opaque.push_back(regions[i].node);
      continue;
    }
    close_opaque();
    tables.layers.push_back({regions[i].node, RegionId(i)});
  }
  close_opaque();
}

}  // namespace

Body body_of(const SceneTables& tables, NodeId node, PartId part, LookId look, std::uint32_t first_leaf) {
  Body body{node, part, look, first_leaf, static_cast<std::uint32_t>(tables.leaves.size()), false};
  bool first = true;
  for (std::uint32_t i = body.first_leaf; i < body.leaf_end; ++i) {
    const Leaf& leaf = tables.leaves[i];
    // A leaf that something subtracts makes no medium.
    if (leaf.holds_nothing) continue;
    if (first) body.look = leaf.look;
    first = false;
    body.transmits = body.transmits || tables.looks[leaf.look.index()].transmits();
  }
  return body;
}

void gather_regions(std::vector<Body> bodies, SceneTables& tables) {
  NodeBuilder nodes(tables);
  add_regions(bodies, tables, nodes);
  tables.root = add_root(tables, nodes);
  complete_parts(tables, nodes);
  add_layers(tables, nodes);
}

}  // namespace csgcast::detail
