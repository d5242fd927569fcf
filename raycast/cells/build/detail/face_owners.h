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

/// Finds the leaves that own the faces in a cell, surface by surface, and the looks that these faces show. Working
/// memory of one thread.
class FaceOwners {
 public:
  struct Owner {
    LeafId leaf;  ///< the only leaf that owns the surface in the cell; not valid if there are more, or none
    LookId look;  ///< the look of every face on the surface in the cell; not valid if that depends on the place
  };

  /// The ground and the fold must outlive this. The fold must be of_rays.
  FaceOwners(const CellGround& ground, BoxFold& fold) : ground_(ground), fold_(fold) {}

  /// Returns the owners of some surfaces, in the order of these. The result is valid until the next call. `formula` is
  /// the formula of the cell, including what others imply.
  std::span<const Owner> find(const Formula& formula, const SurfaceSet& surfaces, const CellBox& box);

 private:
  bool has_one_region(const Formula& formula) const;
  LookId face_look(const Leaf& leaf, bool one_region, const CellBox& box);
  const HolderTree::Shown& cut_look(const CellBox& box);

  const CellGround& ground_;
  BoxFold& fold_;
  std::vector<Owner> owners_;
  std::vector<std::size_t> last_term_;         // by surface: the last term of a leaf that was found to own it
  std::optional<HolderTree::Shown> cut_look_;  // the look of cuts in the cell, once it is known
  HolderTree::Search holder_search_;
};

}  // namespace csgcast::detail
