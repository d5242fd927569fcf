// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "raycast/scene/leaf_function.h"

namespace csgcast::detail {

/// The function of a leaf that has a truth formula of a few half-spaces. In a box, the content is this formula without
/// the parts that the sides of the box settle. It is never open.
class FormulaFunction final : public LeafFunction {
 public:
  explicit FormulaFunction(std::shared_ptr<const TruthFormula> formula) : formula_(std::move(formula)) {}

  Truth value(std::span<const Truth> holds) const override;
  void intervals(std::span<const HalfSpace> half_spaces, LeafLine& line, Span reach, IntervalList& list,
                 std::vector<IntervalList>& scratch) const override;
  Content in_box(std::span<const HalfSpace> half_spaces, LeafBox& box, TruthFormula& terms) const override;

 private:
  std::shared_ptr<const TruthFormula> formula_;
};

}  // namespace csgcast::detail
