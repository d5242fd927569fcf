// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raycast/ray/detail/local_tree.h"
#include "raycast/ray/hit.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// Decides a tree at a point that lies on some of its surfaces. Next to the point each of these may be on either side:
/// the search branches on them one by one, and stops as soon as the choices made decide the tree.
class ChoiceSearch {
 public:
  /// Forgets all half-spaces.
  void clear();
  /// Adds a half-space of the leaf with that slot; `sign` is the sign of its surface at the point: -1, 0 or 1.
  void add(std::uint32_t slot, const HalfSpace& half_space, int sign);
  /// Says that the half-spaces of the leaf with that slot are no conjunction. Precondition: they were added last.
  void set_function(std::uint32_t slot, const LeafFunction& function, std::size_t half_spaces);
  /// Inside or outside if every choice of signs gives that. Precondition: all half-spaces of the tree's leaves have
  /// been added.
  ///
  /// Tries 4096 steps. Where these are not enough, as with hundreds of facets through one point, the answer is the safe
  /// one: boundary.
  Location run(LocalTree& tree);

 private:
  // A half-space of a leaf, and the sign of its surface at the point.
  struct Position {
    std::uint32_t slot;
    bool wants_positive;
    int sign;
    std::uint32_t choice;  // if the sign is zero: where its surface stands in surfaces_
  };

  // A leaf that is no conjunction, and its positions.
  struct FunctionLeaf {
    std::uint32_t slot;
    const LeafFunction* function;
    std::size_t first;
    std::size_t end;
  };

  Truth holds(const Position& position) const;
  int sign_of(const Position& position) const { return position.sign != 0 ? position.sign : chosen_[position.choice]; }
  Truth evaluate(LocalTree& tree);
  std::uint32_t next_choice() const;
  bool turn_last_choice();

  std::vector<Position> positions_;
  std::vector<FunctionLeaf> functions_;
  std::vector<Truth> holds_;          // what a leaf's function is asked with
  std::vector<SurfaceId> surfaces_;   // those that the point lies on
  std::vector<int> chosen_;           // the sign chosen for each of them; 0: none yet
  std::vector<std::uint32_t> order_;  // the choices made, in order
  std::vector<Truth> leaf_truth_;     // by slot, under these choices
};

}  // namespace csgcast::detail
