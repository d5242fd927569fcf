// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raycast/cells/build/cell_data.h"

namespace csgcast::detail {

/// The kd-tree and its cells during construction, in prefix order. It grows and shrinks at its end. The first two cells
/// are the constants false and true.
class CellTree {
 public:
  CellTree();

  /// A state of the tree to which one can return.
  struct Mark {
    std::size_t nodes, cells, slots, steps;
  };
  Mark mark() const { return {nodes_.size(), cells_.size(), slots_.size(), steps_.size()}; }
  /// Removes everything that was added since the mark.
  void return_to(const Mark& mark);

  /// Adds a split, and returns its index. The nodes below it must follow, then a call of `begin_above`, then the nodes
  /// above it.
  std::size_t add_split(std::size_t axis, double at);
  void begin_above(std::size_t split);
  /// Adds an end of the tree with a constant value.
  void add_constant(bool value) { add_end(value ? 1 : 0); }
  /// Adds an end of the tree with a cell of its own. The last slots and steps belong to it.
  void add_cell(const Cell& cell);
  std::vector<Slot>& slots() { return slots_; }
  std::vector<Step>& steps() { return steps_; }

  /// If everything since the mark is one split with the same constant on both sides, the constant replaces it.
  /// Otherwise returns false.
  bool merge_constant(const Mark& since);
  /// Adds another tree in the place where nodes are expected next.
  void append(CellTree&& part);

  /// Moves everything into the data, whose tree must be empty.
  void move_into(CellData& data) &&;

 private:
  void add_end(std::size_t cell);

  std::vector<CellNode> nodes_;
  std::vector<Cell> cells_;
  std::vector<Slot> slots_;
  std::vector<Step> steps_;
};

}  // namespace csgcast::detail
