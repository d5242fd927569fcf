// SPDX-License-Identifier: MIT
#include "raycast/ray/detail/neighbourhood.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "raycast/line/box_line.h"
#include "raycast/scene/leaf_function.h"

namespace csgcast::detail {

Neighbourhood::Neighbourhood(const Scene& scene, LineCache& cache) : scene_(scene), cache_(cache) {}

void Neighbourhood::move_to(NodeId node, const Crossing& crossing) {
  crossing_ = crossing;
  look_around(node, {cache_.earliest(crossing), cache_.latest(crossing)});
  // The surface that a ray departs from passes through the start by definition. A ray that goes nearly along that
  // surface may then have a crossing outside the box of its leaf, so boxes cannot be used.
  if (group_.empty()) look_around(node, Span::line());
}

// Takes the leaves whose boxes the ray meets within the span. If the span is the whole line, it takes all leaves.
void Neighbourhood::look_around(NodeId node, Span at) {
  const bool everywhere = std::isinf(at.from) && std::isinf(at.to);
  tree_.build(scene_, node, [&](const Box& box) {
    Span span = at;
    return everywhere || may_meet(box, cache_.ray(), span);
  });
  positions_.clear();
  leaf_start_.clear();
  bases_.clear();
  chosen_ = not_in_group;
  for (std::uint32_t slot = 0; slot < tree_.leaves().size(); ++slot) add_leaf(slot, tree_.leaves()[slot], crossing_);
  leaf_start_.push_back(static_cast<std::uint32_t>(positions_.size()));
  gather_group();
}

void Neighbourhood::add_leaf(std::uint32_t slot, LeafId leaf, const Crossing& crossing) {
  leaf_start_.push_back(static_cast<std::uint32_t>(positions_.size()));
  for (const HalfSpace& half_space : scene_.half_spaces(scene_.leaf(leaf))) {
    const LineCache::Rank rank = cache_.rank(half_space.surface, crossing);
    const LineCrossings& found = cache_.found(half_space.surface);
    const bool wants_positive = half_space.sense == Sense::positive;
    positions_.push_back({half_space.surface,
                          slot,
                          rank.ties ? 0 : not_in_group,
                          rank.before,
                          {found.positive_after(rank.before) == wants_positive,
                           found.positive_after(rank.before + (rank.ties ? 1u : 0u)) == wants_positive},
                          false});
  }
}

// Gathers the positions whose surfaces tie with the crossing, sorted by surface, then by leaf.
void Neighbourhood::gather_group() {
  by_group_.clear();
  group_.clear();
  group_start_.clear();
  for (std::uint32_t i = 0; i < positions_.size(); ++i) {
    if (positions_[i].group != not_in_group) by_group_.push_back(i);
  }
  const auto key = [this](std::uint32_t i) {
    return std::pair(positions_[i].surface, tree_.leaves()[positions_[i].slot]);
  };
  std::sort(by_group_.begin(), by_group_.end(), [&](auto a, auto b) { return key(a) < key(b); });
  for (std::uint32_t k = 0; k < by_group_.size(); ++k) {
    Position& position = positions_[by_group_[k]];
    if (group_.empty() || group_.back().surface != position.surface) {
      group_.push_back(cache_.crossing(position.surface, position.root));
      group_start_.push_back(k);
    }
    position.group = static_cast<std::uint32_t>(group_.size() - 1);
  }
  group_start_.push_back(static_cast<std::uint32_t>(by_group_.size()));
}

Truth Neighbourhood::leaf_truth(std::uint32_t slot) {
  if (const LeafFunction* function = scene_.leaf(tree_.leaves()[slot]).function) {
    holds_.clear();
    for (std::uint32_t i = leaf_start_[slot]; i < leaf_start_[slot + 1]; ++i)
      holds_.push_back(truth(positions_[i].holds[side_] != positions_[i].flipped));
    return function->value(holds_);
  }
  for (std::uint32_t i = leaf_start_[slot]; i < leaf_start_[slot + 1]; ++i) {
    if (positions_[i].holds[side_] == positions_[i].flipped) return Truth::no;
  }
  return Truth::yes;
}

// Makes a state the present one. Returns the node's value in it.
bool Neighbourhood::set_base(const Base& base) {
  side_ = base.side;
  for (Position& position : positions_) {
    position.flipped = position.group != not_in_group && position.group < base.flipped_groups;
  }
  leaf_truth_.resize(tree_.leaves().size());
  for (std::uint32_t slot = 0; slot < leaf_truth_.size(); ++slot) leaf_truth_[slot] = leaf_truth(slot);
  return tree_.evaluate(leaf_truth_) == Truth::yes;
}

// Flips half-spaces in the present state and returns the node's new value. Positions of one leaf must stand together.
bool Neighbourhood::flip(std::span<const std::uint32_t> positions) {
  for (const std::uint32_t i : positions) positions_[i].flipped = !positions_[i].flipped;
  Truth value = Truth::no;
  for (const std::uint32_t i : positions) value = tree_.update(positions_[i].slot, leaf_truth(positions_[i].slot));
  return value == Truth::yes;
}

// Chooses the lowest surface whose flip alone changes the result, in the state before or after. False if there is none.
bool Neighbourhood::chosen_by_single_flip() {
  for (const Side side : {before, after}) {
    const bool start = set_base({side, 0});
    for (std::uint32_t group = 0; group < group_.size() && group <= chosen_; ++group) {
      const bool changes = flip(positions_of(group)) != start;
      flip(positions_of(group));
      if (!changes) continue;
      if (group < chosen_) bases_.clear();
      chosen_ = group;
      bases_.push_back({side, 0});
      break;
    }
  }
  return chosen_ != not_in_group;
}

// Flips one surface after the other in ascending order until the result changes, once from each side. Chooses the lower
// of the two surfaces that changed it.
void Neighbourhood::chosen_by_walk() {
  for (const Side side : {before, after}) {
    const bool start = set_base({side, 0});
    for (std::uint32_t group = 0; group < group_.size() && group <= chosen_; ++group) {
      if (flip(positions_of(group)) == start) continue;
      if (group < chosen_) bases_.clear();
      chosen_ = group;
      bases_.push_back({side, group});
      break;
    }
  }
}

void Neighbourhood::choose_surface() {
  if (chosen_ != not_in_group || group_.empty()) return;
  if (group_.size() == 1) {
    // If there is only one surface, flipping it leads from one side to the other.
    chosen_ = 0;
    bases_ = {{before, 0}, {after, 0}};
    return;
  }
  if (!chosen_by_single_flip()) chosen_by_walk();
  // There is no choice only if the node does not change at the crossing.
  if (chosen_ == not_in_group) chosen_ = 0;
}

Crossing Neighbourhood::bounding_crossing() {
  choose_surface();
  return chosen_ == not_in_group ? crossing_ : group_[chosen_];
}

// The slot of the first leaf for which this is true: if its copy of the chosen surface alone is flipped, in a base
// state on that side, the result changes.
std::optional<std::uint32_t> Neighbourhood::first_single_copy(Side side) {
  for (const Base& base : bases_) {
    if (base.side != side) continue;
    const bool start = set_base(base);
    for (std::size_t owner = 0; owner < owner_count(); ++owner) {
      const bool changes = flip(copy(owner)) != start;
      flip(copy(owner));
      if (changes) return slot_of(owner);
    }
  }
  return std::nullopt;
}

// The slot of the leaf that the face belongs to, among those that own the chosen surface. Single copies are flipped in
// the state inside the solid first, then in the state outside. If none of them changes the result, one copy after the
// other is flipped. LeafIds ascend in file order.
std::uint32_t Neighbourhood::owner_by_copies() {
  const std::span<const std::uint32_t> owned = positions_of(chosen_);
  owner_start_.clear();
  for (std::uint32_t k = 0; k < owned.size(); ++k) {
    if (k == 0 || positions_[owned[k]].slot != positions_[owned[k - 1]].slot) owner_start_.push_back(k);
  }
  owner_start_.push_back(static_cast<std::uint32_t>(owned.size()));
  if (owner_count() == 1) return slot_of(0);
  const Side inside = set_base({after, 0}) ? after : before;
  if (const auto slot = first_single_copy(inside)) return *slot;
  if (const auto slot = first_single_copy(inside == after ? before : after)) return *slot;
  std::size_t best = owner_count();
  for (const Base& base : bases_) {
    const bool start = set_base(base);
    for (std::size_t owner = 0; owner < best; ++owner) {
      if (flip(copy(owner)) != start) best = owner;
    }
  }
  return slot_of(best < owner_count() ? best : 0);
}

LeafId Neighbourhood::bounding_leaf() {
  choose_surface();
  // If the group is empty, no leaf near the crossing owns the surface, so it is no crossing of this node.
  return chosen_ == not_in_group ? LeafId() : tree_.leaves()[owner_by_copies()];
}

LeafId Neighbourhood::holding_leaf(Passage passage) {
  set_base({passage == Passage::entry ? after : before, 0});
  return tree_.first_holding_leaf();
}

}  // namespace csgcast::detail
