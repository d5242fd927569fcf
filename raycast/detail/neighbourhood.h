// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "raycast/detail/line_cache.h"
#include "raycast/detail/local_tree.h"
#include "raycast/hit.h"
#include "raycast/scene.h"

namespace csgcast::detail {

/// The state of a node's tree right before and right after one crossing of a ray: decides which of several surfaces
/// that tie there bounds the solid, and which leaf the face belongs to (docs/architecture.md, Ties).
class Neighbourhood {
 public:
  Neighbourhood(const Scene& scene, LineCache& cache);

  /// Looks at a crossing of the cache's present ray. The node's state should change there.
  void move_to(NodeId node, const Crossing& crossing);
  /// The bounding surface's crossing, by the tie rule.
  Crossing bounding_crossing();
  /// The leaf whose face it is, by the same rule among the leaves that own the surface.
  LeafId bounding_leaf();
  /// The first leaf in file order that nothing subtracts and that holds what lies right after (entry) or right before
  /// (exit) the crossing; may be invalid.
  LeafId holding_leaf(Passage passage);

 private:
  enum Side : std::uint8_t { before, after };
  static constexpr std::uint32_t not_in_group = 0xffffffffu;

  // One half-space of one near leaf.
  struct Position {
    std::uint32_t slot;   // of the leaf
    std::uint32_t group;  // index into group_ if its surface ties with the crossing
    bool holds[2];        // before and after
  };
  // A state to flip things in: a side, with some surfaces flipped already.
  struct Base {
    Side side;
    std::uint32_t flipped_groups;  // those with a lower index are flipped
  };

  void add_leaf(std::uint32_t slot, LeafId leaf, const Crossing& crossing);
  std::uint32_t group_of(SurfaceId surface, std::uint8_t root);
  void sort_group();
  bool root_value(Side side);
  void reset_flips() { flipped_.assign(positions_.size(), 0); }
  void flip_group(std::uint32_t group);
  void flip_copy(std::uint32_t group, std::uint32_t slot);
  void choose_surface();
  bool chosen_by_single_flip();
  void chosen_by_walk();
  std::uint32_t first_slot_by_copies();
  std::optional<std::uint32_t> first_single_copy(Side side);
  void set_base(const Base& base);

  const Scene& scene_;
  LineCache& cache_;
  LocalTree tree_;
  Crossing crossing_;
  std::vector<Position> positions_;    // by slot, ascending
  std::vector<Crossing> group_;        // the crossings that tie, ascending by surface
  std::vector<std::uint8_t> flipped_;  // by position
  std::vector<Truth> leaf_truth_;
  std::vector<std::uint32_t> owners_;    // slots of the leaves that own the chosen surface
  std::uint32_t chosen_ = not_in_group;  // index into group_
  std::vector<Base> bases_;              // the states in which flipping the chosen surface changes the result
};

}  // namespace csgcast::detail
