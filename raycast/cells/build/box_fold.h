// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "raycast/cells/build/cell_ground.h"
#include "raycast/cells/formula/formula.h"
#include "raycast/scene/leaf_function.h"
#include "raycast/surface/form_range.h"

namespace csgcast::detail {

/// Examines one box after another. It finds on which sides of surfaces a box lies, and folds formulas accordingly. The
/// sides of a surface are found once for each box. Working memory of one thread.
class BoxFold final : private LeafBox {
 public:
  /// The places in a box for which the sides must be correct.
  enum class Places : std::uint8_t {
    exact,   ///< the points of the box itself
    of_rays  ///< places along rays, which may be off; the box is treated as wide as a cell is
  };

  /// The ground must outlive this.
  BoxFold(const CellGround& ground, Places places);

  /// Goes on to another box. The box must be finite, unless places are of_rays.
  void enter(const CellBox& box);
  /// The sides of a surface that the box meets. The answer is `both` if that is not known.
  Sides sides_of(SurfaceId id) override {
    const std::size_t i = id.index();
    if (asked_in_[i] != box_number_) {
      asked_in_[i] = box_number_;
      answer_[i] = find_sides(id);
    }
    return answer_[i];
  }
  /// `yes` if all of the box is on that side of the surface, `no` if nothing of it is.
  Truth known_of(SurfaceId id, bool positive) {
    const Sides sides = sides_of(id);
    if (sides == Sides::both) return Truth::unknown;
    return (sides == Sides::positive) == positive ? Truth::yes : Truth::no;
  }
  /// `yes` if the leaf holds all of the box, `no` if it holds nothing of it.
  Truth known_of(LeafId id);

  /// Enters a box, and sets `result` to the formula folded in it. Precondition: they are different formulas.
  void fold(const Formula& from, const CellBox& box, Formula& result);

 private:
  Sides find_sides(SurfaceId id) const;
  Box in_scene() const override { return ground_.scene_box_of(box_); }
  FoldedTerm folded(const Term& half_space);
  FoldedTerm folded(LeafId leaf);

  const CellGround& ground_;
  Places places_;
  CellBox box_{};
  Folder folder_;
  Folder leaf_folder_;
  Formula leaf_whole_;   // the formula of a leaf that is not a conjunction in the box
  Formula leaf_folded_;  // the same, folded with what is known there
  TruthFormula leaf_terms_;
  std::uint32_t box_number_ = 0;
  std::vector<std::uint32_t> asked_in_;  // by surface: the number of the box that the answer belongs to
  std::vector<Sides> answer_;            // by surface
};

}  // namespace csgcast::detail
