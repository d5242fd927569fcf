// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "raycast/cells/formula/formula.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// The part of a scene's tree that can hold places. Subtracted operands are left out. A cut shows the look of the first
/// leaf, in file order, that holds the place and that nothing subtracts (Neighbourhood::holding_leaf).
class HolderTree {
 public:
  HolderTree() = default;  ///< for scenes without cuts: the tree is empty
  HolderTree(const Scene& scene, NodeId root);

  /// Working memory of one thread.
  struct Search {
    struct Candidate {
      std::uint32_t leaf;
      bool is_sure;
    };
    std::vector<Truth> value;
    std::vector<Candidate> candidates;
  };

  /// The look of cuts in some part of space.
  struct Shown {
    bool is_one = false;  ///< true if every holder there looks the same; also false if there are too many to examine
    LookId look;          ///< the look of all holders, if is_one; not valid if there is no holder
    bool may_be_none = false;  ///< true if some place may have no holder; a cut shows its region's look there
  };

  /// The look of cuts in a part of space. `leaf` tells if a leaf holds all of that part, nothing of it, or some of it
  /// as far as is known.
  Shown shown(const Scene& scene, Search& search, const std::function<Truth(LeafId)>& leaf) const;

 private:
  struct Entry {
    enum class Op : std::uint8_t { leaf, unite, intersect, subtract, other };
    Op op = Op::other;
    std::uint32_t end = 0;  ///< the index after its operands, which follow it
    LeafId leaf;
  };

  void evaluate(Search& search, const std::function<Truth(LeafId)>& leaf) const;
  void gather(Search& search) const;

  std::vector<Entry> entries_;  // in prefix order
  bool is_small_ = false;
};

}  // namespace csgcast::detail
