// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "raycast/cells/formula/formula.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// What a cut shows is the look of the first leaf, in file order, that holds the place and that nothing subtracts
/// (Neighbourhood::holding_leaf). This is the part of a scene's tree that can hold places: no subtrahends.
class HolderTree {
 public:
  HolderTree() = default;
  HolderTree(const Scene& scene, NodeId root);

  /// Whether there are few enough leaves to look at all of them for each cell.
  bool is_small() const { return is_small_; }

  /// Working memory of one thread.
  struct Search {
    struct Candidate {
      std::uint32_t leaf;
      bool is_sure;
    };
    std::vector<Known> value;
    std::vector<Candidate> candidates;
  };

  /// What cuts show in some part of space.
  struct Shown {
    bool is_one = false;       ///< every holder there looks the same
    LookId look;               ///< then: how; not valid if there is none
    bool may_be_none = false;  ///< some place may have no holder: a cut shows its region's look there
  };

  /// `leaf`: whether a leaf holds all of that part, none or, as far as is known, some.
  Shown shown(const Scene& scene, Search& search, const std::function<Known(LeafId)>& leaf) const;

 private:
  struct Entry {
    enum class Op : std::uint8_t { leaf, unite, intersect, subtract, other };
    Op op = Op::other;
    std::uint32_t end = 0;  ///< after its operands, which follow it
    LeafId leaf;
  };

  void evaluate(Search& search, const std::function<Known(LeafId)>& leaf) const;
  void gather(Search& search) const;

  std::vector<Entry> entries_;  // in prefix order
  bool is_small_ = false;
};

}  // namespace csgcast::detail
