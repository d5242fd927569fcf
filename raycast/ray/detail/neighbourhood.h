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

/// The state of a node's tree right before and right after one crossing of a ray. If several surfaces tie at the
/// crossing, this class decides which of them bounds the solid and which leaf the face belongs to (docs/answer.md,
/// "Whose face it is").
class Neighbourhood {
 public:
  Neighbourhood(const Scene& scene, LineCache& cache);

  /// Turns to a crossing of the cache's present ray. The ray should enter or leave the node there.
  void move_to(NodeId node, const Crossing& crossing);
  /// The crossing of the surface that bounds the node there, by the tie rule. If no leaf of the node owns a surface
  /// that ties with the crossing, the crossing itself is returned.
  Crossing bounding_crossing();
  /// The leaf whose face is there, by the same rule among the leaves that own the bounding surface. It is not valid if
  /// the node has no boundary at the crossing.
  LeafId bounding_leaf();
  /// The first leaf in file order that holds the place right after an entry or right before an exit, among the leaves
  /// that nothing subtracts. It is not valid if there is none.
  LeafId holding_leaf(Passage passage);

 private:
  enum Side : std::uint8_t { before, after };
  static constexpr std::uint32_t not_in_group = 0xffffffffu;

  // One half-space of one leaf near the crossing.
  struct Position {
    SurfaceId surface;
    std::uint32_t slot;   // the leaf's slot
    std::uint32_t group;  // index into group_ if its surface ties with the crossing, else not_in_group
    std::uint8_t root;    // the number of the surface's crossing that ties
    bool holds[2];        // by Side: true if the half-space holds the ray there
    bool flipped;         // true if the present state takes the opposite of `holds`
  };
  // A state in which surfaces are flipped one by one. It is the state on one side, with some surfaces flipped already.
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
  std::vector<std::uint32_t> leaf_start_;   // by slot: where its positions start, and the end
  std::vector<Crossing> group_;             // the crossings that tie, ascending by surface
  std::vector<std::uint32_t> by_group_;     // positions that tie, by group, then by leaf in file order
  std::vector<std::uint32_t> group_start_;  // by group: where its positions start in by_group_, and the end
  std::vector<std::uint32_t> owner_start_;  // the same for each leaf that owns the chosen surface
  std::vector<Truth> leaf_truth_;
  std::vector<Truth> holds_;             // the arguments for a leaf's function
  std::uint32_t chosen_ = not_in_group;  // the bounding surface, an index into group_, once it is chosen
  std::vector<Base> bases_;              // the states in which a flip of the chosen surface changes the result
};

}  // namespace csgcast::detail
