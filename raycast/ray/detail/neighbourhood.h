// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "raycast/ray/detail/line_cache.h"
#include "raycast/ray/detail/local_tree.h"
#include "raycast/ray/hit.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// The state of a node's tree right before and right after one crossing of a ray. Where several surfaces tie there it
/// decides which of them bounds the solid, and which leaf the face belongs to (docs/answer.md, "Whose face it is").
class Neighbourhood {
 public:
  Neighbourhood(const Scene& scene, LineCache& cache);

  /// Turns to a crossing of the cache's present ray, one at which the ray should enter or leave the node.
  void move_to(NodeId node, const Crossing& crossing);
  /// The crossing of the surface that bounds the node there, by the tie rule. If no leaf of the node owns a surface
  /// that ties with the crossing, the crossing itself.
  Crossing bounding_crossing();
  /// The leaf whose face is there, by the same rule among the leaves that own the bounding surface. Not valid if the
  /// crossing is none of this node.
  LeafId bounding_leaf();
  /// The first leaf in file order, of those that nothing subtracts, that holds the place right after an entry or right
  /// before an exit. Not valid if there is none.
  LeafId holding_leaf(Passage passage);

 private:
  enum Side : std::uint8_t { before, after };
  static constexpr std::uint32_t not_in_group = 0xffffffffu;

  // One half-space of one leaf near the crossing.
  struct Position {
    SurfaceId surface;
    std::uint32_t slot;   // of the leaf
    std::uint32_t group;  // index into group_ if its surface ties with the crossing, else not_in_group
    std::uint8_t root;    // which of the surface's crossings ties
    bool holds[2];        // by Side: it holds the ray there
    bool flipped;         // the present state takes the opposite of that
  };
  // A state in which surfaces are flipped one by one: that on one side, with some surfaces flipped already.
  struct Base {
    Side side;
    std::uint32_t flipped_groups;  // the groups with an index below this one are flipped
  };

  void look_around(NodeId node, Span at);
  void add_leaf(std::uint32_t slot, LeafId leaf, const Crossing& crossing);
  void gather_group();
  std::span<const std::uint32_t> positions_of(std::uint32_t group) const {
    return std::span(by_group_).subspan(group_start_[group], group_start_[group + 1] - group_start_[group]);
  }
  bool set_base(const Base& base);
  bool flip(std::span<const std::uint32_t> positions);
  Truth leaf_truth(std::uint32_t slot);
  void choose_surface();
  bool chosen_by_single_flip();
  void chosen_by_walk();
  std::uint32_t owner_by_copies();
  std::optional<std::uint32_t> first_single_copy(Side side);
  std::span<const std::uint32_t> copy(std::size_t owner) const {
    return positions_of(chosen_).subspan(owner_start_[owner], owner_start_[owner + 1] - owner_start_[owner]);
  }
  std::size_t owner_count() const { return owner_start_.size() - 1; }
  std::uint32_t slot_of(std::size_t owner) const { return positions_[copy(owner).front()].slot; }

  const Scene& scene_;
  LineCache& cache_;
  LocalTree tree_;
  Crossing crossing_;
  Side side_ = before;                      // the side of the present state
  std::vector<Position> positions_;         // by slot, ascending
  std::vector<std::uint32_t> leaf_start_;   // where each slot's positions start, and the end
  std::vector<Crossing> group_;             // the crossings that tie, ascending by surface
  std::vector<std::uint32_t> by_group_;     // positions that tie, by group, then by leaf in file order
  std::vector<std::uint32_t> group_start_;  // where each group's positions start in by_group_, and the end
  std::vector<std::uint32_t> owner_start_;  // the same for the leaves that own the chosen surface
  std::vector<Truth> leaf_truth_;
  std::vector<Truth> holds_;             // what a leaf's function is asked with
  std::uint32_t chosen_ = not_in_group;  // the bounding surface, an index into group_, once it is chosen
  std::vector<Base> bases_;              // the states in which flipping the chosen surface changes the result
};

}  // namespace csgcast::detail
