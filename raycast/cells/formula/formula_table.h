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

/// A formula's value in each state of its surfaces. The i-th surface is positive in the states with bit i. There are 64
/// states in a word, and at least one word; unused states repeat the others. The object keeps its memory.
class FormulaTable {
 public:
  /// Becomes the table of a formula over a set that contains its surfaces. Time and memory are of the order of 2^n for
  /// n surfaces. Precondition: the formula is not constant.
  void tabulate(const Formula& formula, const SurfaceSet& surfaces);

  /// True if the value depends on the i-th surface in some state.
  bool depends_on(std::size_t i) const;
  /// The table over at most six of the surfaces, given by their places in ascending order. The value must not depend on
  /// the other surfaces.
  std::uint64_t over(std::span<const std::size_t> places) const;
  /// The table as a function of eight values. Values beyond the number of surfaces do not matter. Precondition: there
  /// are at most eight surfaces.
  TruthTable as_function() const;

 private:
  FormulaValue value_;
  std::size_t count_ = 0;  // the number of surfaces
  std::vector<std::uint64_t> words_;
};

}  // namespace csgcast::detail
