// SPDX-License-Identifier: MIT
#include "raycast/cells/cells.h"

#include <utility>

#include "raycast/cells/build/box_tree.h"
#include "raycast/cells/build/cell_builder.h"
#include "raycast/cells/build/cell_ground.h"
#include "raycast/cells/cells_data.h"
#include "raycast/cells/formula/formula.h"

namespace csgcast {

namespace {

// A ray asks for these first, and waits for them. So they are written last, without spare room, and are in the cache
// then.
void bring_near(detail::CellData& data) {
  data.cells = std::vector(data.cells);
  data.nodes = std::vector(data.nodes);
}

detail::CellData cells_of(const Scene& scene, NodeId node) {
  const detail::CellGround ground(scene, node);
  const detail::Formula whole = detail::formula_of(scene, node);
  detail::CellData data = detail::build_cells(ground, node, whole);
  detail::add_box_tree(ground, whole, data);
  bring_near(data);
  return data;
}

}  // namespace

Cells::Cells(const Scene& scene, NodeId node)
    : scene_(&scene), node_(node), data_(std::make_unique<const Data>(cells_of(scene, node))) {}

Cells::~Cells() = default;
Cells::Cells(Cells&&) noexcept = default;

Cells::Counts Cells::counts() const {
  Counts counts;
  counts.nodes = data_->nodes.size();
  for (const detail::Cell& cell : data_->cells) {
    if (cell.slot_count == 0 && !cell.is_undecided) continue;
    ++counts.cells;
    counts.surfaces += cell.slot_count;
    counts.large += cell.step_count > 0 ? 1 : 0;
    counts.undecided += cell.is_undecided ? 1 : 0;
  }
  const auto bytes_of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
  const detail::BoxTree& boxes = data_->boxes;
  counts.boxed = boxes.conjunctions.size();
  counts.bytes = bytes_of(data_->nodes) + bytes_of(data_->cells) + bytes_of(data_->slots) + bytes_of(data_->steps) +
                 bytes_of(boxes.nodes) + bytes_of(boxes.conjunctions) + bytes_of(boxes.sides);
  return counts;
}

}  // namespace csgcast
