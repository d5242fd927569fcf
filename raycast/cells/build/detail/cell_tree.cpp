// SPDX-License-Identifier: MIT
#include "raycast/cells/build/detail/cell_tree.h"

#include <utility>

namespace csgcast::detail {
namespace {

constexpr std::uint32_t constants = 2;  // the number of constant cells in front

}  // namespace

CellTree::CellTree() : cells_(constants) { cells_[1].table = 1; }

void CellTree::return_to(const Mark& mark) {
  nodes_.resize(mark.nodes);
  cells_.resize(mark.cells);
  slots_.resize(mark.slots);
  steps_.resize(mark.steps);
}

std::size_t CellTree::add_split(std::size_t axis, double at) {
  nodes_.push_back({at, 0, static_cast<std::uint32_t>(axis)});
  return nodes_.size() - 1;
}

void CellTree::begin_above(std::size_t split) { nodes_[split].above = static_cast<std::uint32_t>(nodes_.size()); }

void CellTree::add_end(std::size_t cell) {
  nodes_.push_back({0, static_cast<std::uint32_t>(cell), CellNode::no_axis});
  nodes_.back().set_first_slot(cells_[cell].first_slot);
}

void CellTree::add_cell(const Cell& cell) {
  cells_.push_back(cell);
  add_end(cells_.size() - 1);
}

bool CellTree::merge_constant(const Mark& since) {
  if (nodes_.size() != since.nodes + 3) return false;
  const CellNode below = nodes_[since.nodes + 1];
  const CellNode above = nodes_[since.nodes + 2];
  if (!below.is_end() || !above.is_end() || below.above >= constants || below.above != above.above) return false;
  return_to(since);
  nodes_.push_back(above);
  return true;
}

void CellTree::append(CellTree&& part) {
  const auto nodes = static_cast<std::uint32_t>(nodes_.size());
  const auto cells = static_cast<std::uint32_t>(cells_.size()) - constants;
  const auto slots = static_cast<std::uint32_t>(slots_.size());
  const auto steps = static_cast<std::uint32_t>(steps_.size());
  for (CellNode& node : part.nodes_) {
    if (!node.is_end()) {
      node.above += nodes;
    } else if (node.above >= constants) {
      node.above += cells;
      node.set_first_slot(node.first_slot() + slots);
    }
  }
  for (Cell& cell : part.cells_) {
    cell.first_slot += slots;
    cell.first_step += steps;
  }
  nodes_.insert(nodes_.end(), part.nodes_.begin(), part.nodes_.end());
  cells_.insert(cells_.end(), part.cells_.begin() + constants, part.cells_.end());
  slots_.insert(slots_.end(), part.slots_.begin(), part.slots_.end());
  steps_.insert(steps_.end(), part.steps_.begin(), part.steps_.end());
}

void CellTree::move_into(CellData& data) && {
  data.nodes = std::move(nodes_);
  data.cells = std::move(cells_);
  data.slots = std::move(slots_);
  data.steps = std::move(steps_);
}

}  // namespace csgcast::detail
