// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raycast/ray/detail/local_tree.h"
#include "raycast/ray/hit.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// Decides a tree at a point that lies on some of its surfaces. Close to the point there are places on either side of
/// each of these surfaces. The search branches on them one by one, and stops as soon as the choices decide the tree.
class ChoiceSearch {
 public:
  /// Forgets all half-spaces.
  void clear();
  /// Adds a half-space of the leaf with that slot; `sign` is the sign of its surface at the point: -1, 0 or 1.
  void add(std::uint32_t slot, const HalfSpace& half_space, int sign);
  /// Says that the leaf with that slot is not a conjunction of its half-spaces. Precondition: they were added last.
  void set_function(std::uint32_t slot, const LeafFunction& function, std::size_t half_spaces);
  /// The location, if it is the same for every choice of signs. Precondition: all half-spaces of the tree's leaves have
  /// been added.
  ///
  /// The search takes at most 4096 steps. If these are not enough, for example with hundreds of facets through one
  /// point, the answer is the safe one: boundary.
  Location run(LocalTree& tree);

 private:
  // A half-space of a leaf, and the sign of its surface at the point.
  struct Position {
    std::uint32_t slot;
    bool wants_positive;
    int sign;
    std::uint32_t choice;  // if the sign is zero: the index of its surface in surfaces_
  };

  // A leaf that is not a conjunction, and the range of its positions.
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
  std::vector<Truth> holds_;          // the arguments for a leaf's function
  std::vector<SurfaceId> surfaces_;   // the surfaces that the point lies on
  std::vector<int> chosen_;           // the sign chosen for each of these surfaces; 0 if none is chosen yet
  std::vector<std::uint32_t> order_;  // the choices made, in order
  std::vector<Truth> leaf_truth_;     // by slot, under the present choices
};

}  // namespace csgcast::detail
