// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "raycast/cells/build/box_fold.h"
#include "raycast/cells/build/cell_ground.h"
#include "raycast/cells/build/cut_look.h"
#include "raycast/cells/formula/formula.h"
#include "raycast/cells/formula/surface_set.h"

namespace csgcast::detail {

/// Finds whose faces the surfaces of a cell make there, and what these faces show. Working memory of one thread.
class FaceOwners {
 public:
  struct Owner {
    LeafId leaf;  ///< the only one that owns the surface in the cell; not valid if there are more, or none
    LookId look;  ///< what every face on the surface shows in the cell; not valid if that depends on the place
  };

  /// The ground and the fold, which is for rays, must outlive this.
  FaceOwners(const CellGround& ground, BoxFold& fold) : ground_(ground), fold_(fold) {}

  /// The owners of some surfaces, in their order, until the next call. `formula` is what is in the cell, with nothing
  /// left out that others imply.
  std::span<const Owner> find(const Formula& formula, const SurfaceSet& surfaces, const CellBox& box);

 private:
  bool has_one_region(const Formula& formula) const;
  LookId face_look(const Leaf& leaf, bool one_region, const CellBox& box);
  const HolderTree::Shown& cut_look(const CellBox& box);

  const CellGround& ground_;
  BoxFold& fold_;
  std::vector<Owner> owners_;
  std::vector<std::size_t> last_term_;         // by surface: of the last leaf that was found to own it
  std::optional<HolderTree::Shown> cut_look_;  // in the cell, once it is known
  HolderTree::Search holder_search_;
};

}  // namespace csgcast::detail
