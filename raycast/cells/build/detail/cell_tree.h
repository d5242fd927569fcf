// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raycast/cells/build/cell_data.h"

namespace csgcast::detail {

/// The kd-tree and its cells while they are made, in prefix order: it grows and shrinks at its end. Its first two cells
/// are the constants false and true.
class CellTree {
 public:
  CellTree();

  /// A state of the tree that one may want to return to.
  struct Mark {
    std::size_t nodes, cells, slots, steps;
  };
  Mark mark() const { return {nodes_.size(), cells_.size(), slots_.size(), steps_.size()}; }
  /// Takes away what was added since.
  void return_to(const Mark& mark);

  /// Adds a split, whose index is returned. What is below it is to follow, then `begin_above`, and what is above it.
  std::size_t add_split(std::size_t axis, double at);
  void begin_above(std::size_t split);
  /// Adds an end of the tree that has one value.
  void add_constant(bool value) { add_end(value ? 1 : 0); }
  /// Adds an end of the tree with a cell of its own, whose slots and steps are the last ones.
  void add_cell(const Cell& cell);
  std::vector<Slot>& slots() { return slots_; }
  std::vector<Step>& steps() { return steps_; }

  /// If all that was added since is a split with the same constant on both sides, that constant takes its place. False
  /// if it is not.
  bool merge_constant(const Mark& since);
  /// Adds another tree, to be what follows.
  void append(CellTree&& part);

  /// Moves all into the data, where the tree has been nothing so far.
  void move_into(CellData& data) &&;

 private:
  void add_end(std::size_t cell);

  std::vector<CellNode> nodes_;
  std::vector<Cell> cells_;
  std::vector<Slot> slots_;
  std::vector<Step> steps_;
};

}  // namespace csgcast::detail
