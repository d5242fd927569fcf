// SPDX-License-Identifier: MIT
#include "raycast/scene/scene.h"

#include <utility>

#include "csg/solid/simplify.h"
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
