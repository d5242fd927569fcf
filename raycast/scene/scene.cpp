// SPDX-License-Identifier: MIT
#include "raycast/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "csg/base/length.h"
#include "csg/solid/simplify.h"
#include "raycast/scene/detail/boundedness.h"
#include "raycast/scene/detail/compile.h"
#include "raycast/scene/detail/enclosure.h"
#include "raycast/scene/detail/flattener.h"
#include "raycast/scene/detail/node_builder.h"
#include "raycast/scene/detail/regions.h"
#include "raycast/scene/detail/surface_welding.h"

namespace csgcast {
namespace {

constexpr std::uint64_t most_leaves = std::uint64_t{1} << 22;

void check_tolerance(const Welding& welding) {
  if (welding.mode != Welding::Mode::by_hand) return;
  if (welding.tolerance > 0 && welding.tolerance <= Welding::greatest_tolerance) return;
  throw Error(ErrorCode::bad_value, {}, "the tolerance of welding is out of range",
              "it is a share of the size of the scene, above 0 and at most 1/128", "choose a smaller one, or none");
}

void check_leaf_count(const Solid& solid) {
  if (solid.leaf_count() <= most_leaves) return;
  throw Error(ErrorCode::limit, solid.place(), "the scene has more than 4,194,304 leaves",
              "each use of a shared solid counts", "render it in pieces");
}

// A box that holds everything bounded. It is null if there is nothing.
Box extent(const detail::Flattened& flat) {
  const SceneTables& tables = flat.tables;
  if (!tables.bounded_leaves.is_null()) return tables.bounded_leaves;
  // A solid may be bounded although all its leaves are unbounded.
  Box box;
  for (const detail::Body& body : flat.bodies) box = hull(box, tables.nodes[body.node.index()].box);
  return box;
}

double farthest(const Box& box) { return std::fmax(longest(as_vector(box.lower)), longest(as_vector(box.upper))); }

// Which leaves have finite boxes.
std::vector<bool> bounded_leaves(const SceneTables& tables) {
  std::vector<bool> is_bounded(tables.leaves.size());
  for (const Node& node : tables.nodes) {
    if (node.op == Node::Op::leaf && node.box.is_finite()) is_bounded[node.first] = true;
  }
  return is_bounded;
}

// Surfaces whose leaves are all bounded, or below a node that is cut, matter in the frame's cube only.
void tell_local_surfaces(detail::Flattened& flat, const std::vector<bool>& matters_nearby) {
  const SceneTables& tables = flat.tables;
  std::vector<bool> is_local(flat.surfaces.size(), true);
  for (std::size_t i = 0; i < tables.leaves.size(); ++i) {
    if (matters_nearby[i]) continue;
    const Leaf& leaf = tables.leaves[i];
    for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k)
      is_local[tables.half_spaces[k].surface.index()] = false;
  }
  flat.surfaces.set_local(is_local);
}

// A solid of unbounded leaves may be bounded, as a cone between two half-spaces is. Solids at union level are asked one
// by one.
void bound_bodies(detail::Flattened& flat) {
  constexpr double greatest = 0x1p400;
  SceneTables& tables = flat.tables;
  std::vector<bool> is_bounded = bounded_leaves(tables);
  detail::Boundedness boundedness(tables, flat.surfaces);
  bool any_is_cut = false;
  for (const detail::Body& body : flat.bodies) {
    Node& node = tables.nodes[body.node.index()];
    const auto first = is_bounded.begin() + body.first_leaf, last = is_bounded.begin() + body.leaf_end;
    if (node.box.is_null() || (node.box.is_finite() && std::find(first, last, false) == last)) continue;
    const detail::Extent extent = boundedness.of(body.node);
    if (extent.kind == detail::Extent::Kind::bounded && extent.box.is_null()) {
      node = {};
      continue;
    }
    if (extent.kind == detail::Extent::Kind::bounded && farthest(extent.box) <= greatest) node.box = extent.box;
    if (!node.box.is_finite()) {
      const bool is_certain = extent.kind == detail::Extent::Kind::unbounded;
      const Place place = first == last ? Place() : tables.leaves[body.first_leaf].place;
      if (!tables.opening) tables.opening = {extent.direction, is_certain, place};
      continue;
    }
    node.is_cut = true;
    any_is_cut = true;
    std::fill(first, last, true);
    tables.bounded_leaves = hull(tables.bounded_leaves, node.box);
  }
  if (any_is_cut) tell_local_surfaces(flat, is_bounded);
}

void give_back_spare_memory(SceneTables& tables) {
  tables.leaves.shrink_to_fit();
  tables.half_spaces.shrink_to_fit();
  tables.nodes.shrink_to_fit();
  tables.children.shrink_to_fit();
  tables.operations.shrink_to_fit();
}

}  // namespace

Scene::Scene(SceneTables tables) : tables_(std::move(tables)) {
  for (std::uint32_t id = 0; id < tables_.leaves.size(); ++id) {
    if (tables_.leaves[id].function != nullptr) function_leaves_.emplace_back(id);
  }
  leads_away_ = detail::sides_that_lead_away(*this);
}

Scene detail::compile(Solid solid, const Welding& welding, SurfaceKinds kinds) {
  check_tolerance(welding);
  solid = simplified(solid);
  check_leaf_count(solid);
  detail::Flattened flat = detail::flatten(solid, welding.mode);
  SceneTables& tables = flat.tables;
  if (flat.origins) {
    const Box everything = extent(flat);
    tables.weld_report =
        detail::weld_surfaces(welding, everything, *std::exchange(flat.origins, std::nullopt), flat.surfaces, tables);
  }
  // From here on, the scene itself needs the memory.
  solid = {};
  bound_bodies(flat);
  detail::gather_regions(std::move(flat.bodies), tables);
  tables.bounds = tables.nodes[tables.root.index()].box;
  detail::widen_boxes(tables.nodes, tables.weld_report.widest);
  tables.frame = Frame::around(tables.bounded_leaves);
  give_back_spare_memory(tables);
  tables.surfaces = flat.surfaces.take(tables.frame, kinds);
  return Scene(std::move(tables));
}

Scene compile(Solid solid, const Welding& welding) {
  return detail::compile(std::move(solid), welding, surface_kinds());
}

}  // namespace csgcast
