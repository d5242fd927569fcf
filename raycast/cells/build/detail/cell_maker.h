// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "raycast/cells/build/box_fold.h"
#include "raycast/cells/build/cell_ground.h"
#include "raycast/cells/build/detail/cell_tree.h"
#include "raycast/cells/build/detail/face_owners.h"
#include "raycast/cells/formula/formula.h"
#include "raycast/cells/formula/formula_table.h"
#include "raycast/cells/formula/surface_set.h"

namespace csgcast::detail {

/// The content of a box: the solid's formula there.
struct CellContent {
  const Formula& formula;
  /// If half-spaces were left out because others imply them, this is an earlier formula of the box, or of one around
  /// it. The owners of faces are found by it. It is null if nothing was left out.
  const Formula* with_all = nullptr;
};

/// Makes cells: the ends of the kd-tree. Working memory of one thread.
class CellMaker {
 public:
  /// The fold must be of_rays. All arguments must outlive this.
  CellMaker(const CellGround& ground, BoxFold& fold, CellTree& tree);

  /// Adds the content of a box as one end of the tree, and returns the expected cost of a ray there. The box may be
  /// infinite; the formula is folded in it.
  double add(const CellContent& content, const CellBox& box);

 private:
  bool set_table(const Formula& formula, Cell& cell);
  void add_slots(const CellContent& content, const CellBox& box, Cell& cell);
  void add_steps(const Formula& formula, Cell& cell);

  const CellGround& ground_;
  BoxFold& fold_;
  CellTree& tree_;
  FaceOwners owners_;
  SurfaceSet surfaces_;  // the cell's surfaces, in the order of its slots
  FormulaTable table_;
  std::vector<std::size_t> kept_;  // the places of the surfaces that matter
  Formula with_all_;               // the cell's formula with nothing left out
};

}  // namespace csgcast::detail
