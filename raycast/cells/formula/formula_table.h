// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "csg/base/truth_table.h"
#include "raycast/cells/formula/formula.h"
#include "raycast/cells/formula/surface_set.h"

namespace csgcast::detail {

/// A formula's value in each state of its surfaces: the i-th surface is positive in the states with bit i. There are
/// 64 states a word, and at least one word; unused states repeat the others. Keeps its memory.
class FormulaTable {
 public:
  /// Becomes the table of a formula over a set that contains its surfaces. Takes time and memory by the second power of
  /// two of their number. Precondition: the formula is not constant.
  void tabulate(const Formula& formula, const SurfaceSet& surfaces);

  /// True if the value depends on the i-th surface in some state.
  bool depends_on(std::size_t i) const;
  /// The table over some of the surfaces only, at most six, whose places ascend. The others must not matter.
  std::uint64_t over(std::span<const std::size_t> places) const;
  /// The table as a function of eight values, of which those that are no surface's do not matter. Precondition: there
  /// are at most eight surfaces.
  TruthTable as_function() const;

 private:
  FormulaValue value_;
  std::size_t count_ = 0;  // of the surfaces
  std::vector<std::uint64_t> words_;
};

}  // namespace csgcast::detail
