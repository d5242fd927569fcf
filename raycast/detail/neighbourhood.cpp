// SPDX-License-Identifier: MIT
#include "raycast/detail/neighbourhood.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "raycast/detail/box_line.h"

namespace csgcast::detail {

Neighbourhood::Neighbourhood(const Scene& scene, LineCache& cache) : scene_(scene), cache_(cache) {}

void Neighbourhood::move_to(NodeId node, const Crossing& crossing) {
  crossing_ = crossing;
  const Span at{cache_.earliest(crossing), cache_.latest(crossing)};
  tree_.build(scene_, node, [&](const Box& box) {
    Span span = at;
    return may_meet(box, cache_.ray(), span);
  });
  positions_.clear();
  group_.clear();
  bases_.clear();
  chosen_ = not_in_group;
  for (std::uint32_t slot = 0; slot < tree_.leaves().size(); ++slot) add_leaf(slot, tree_.leaves()[slot], crossing);
  sort_group();
  leaf_truth_.assign(tree_.leaves().size(), Truth::no);
  reset_flips();
}

void Neighbourhood::add_leaf(std::uint32_t slot, LeafId leaf, const Crossing& crossing) {
  for (const HalfSpace& half_space : scene_.half_spaces(scene_.leaf(leaf))) {
    const LineCache::Rank rank = cache_.rank(half_space.surface, crossing);
    const LineCrossings& found = cache_.found(half_space.surface);
    const bool wants_positive = half_space.sense == Sense::positive;
    positions_.push_back({slot,
                          rank.ties ? group_of(half_space.surface, rank.before) : not_in_group,
                          {found.positive_after(rank.before) == wants_positive,
                           found.positive_after(rank.before + (rank.ties ? 1u : 0u)) == wants_positive}});
  }
}

std::uint32_t Neighbourhood::group_of(SurfaceId surface, std::uint8_t root) {
  const auto known =
      std::find_if(group_.begin(), group_.end(), [&](const Crossing& c) { return c.surface == surface; });
  const auto index = static_cast<std::uint32_t>(known - group_.begin());
  if (known == group_.end()) group_.push_back(cache_.crossing(surface, root));
  return index;
}

void Neighbourhood::sort_group() {
  if (group_.size() < 2) return;
  std::vector<std::uint32_t> order(group_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return group_[a].surface < group_[b].surface; });
  std::vector<std::uint32_t> new_index(group_.size());
  std::vector<Crossing> sorted;
  for (const std::uint32_t old : order) {
    new_index[old] = static_cast<std::uint32_t>(sorted.size());
    sorted.push_back(group_[old]);
  }
  group_ = std::move(sorted);
  for (Position& position : positions_) {
    if (position.group != not_in_group) position.group = new_index[position.group];
  }
}

// The node's value on one side of the crossing, with the flips applied.
bool Neighbourhood::root_value(Side side) {
  std::fill(leaf_truth_.begin(), leaf_truth_.end(), Truth::yes);
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    const Position& position = positions_[i];
    if (position.holds[side] == (flipped_[i] != 0)) leaf_truth_[position.slot] = Truth::no;
  }
  return tree_.evaluate(leaf_truth_) == Truth::yes;
}

void Neighbourhood::flip_group(std::uint32_t group) {
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (positions_[i].group == group) flipped_[i] = !flipped_[i];
  }
}

void Neighbourhood::flip_copy(std::uint32_t group, std::uint32_t slot) {
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (positions_[i].group == group && positions_[i].slot == slot) flipped_[i] = !flipped_[i];
  }
}

void Neighbourhood::set_base(const Base& base) {
  reset_flips();
  for (std::uint32_t group = 0; group < base.flipped_groups; ++group) flip_group(group);
}

// The lowest surface whose flip alone, before or after, changes the result.
bool Neighbourhood::chosen_by_single_flip() {
  reset_flips();
  const bool value[2] = {root_value(before), root_value(after)};
  for (std::uint32_t group = 0; group < group_.size(); ++group) {
    reset_flips();
    flip_group(group);
    for (const Side side : {before, after}) {
      if (root_value(side) != value[side]) bases_.push_back({side, 0});
    }
    if (bases_.empty()) continue;
    chosen_ = group;
    return true;
  }
  return false;
}

// Flips the surfaces one by one in ascending order, from both sides; the lower of the first ones that change the
// result.
void Neighbourhood::chosen_by_walk() {
  for (const Side side : {before, after}) {
    reset_flips();
    const bool start = root_value(side);
    for (std::uint32_t group = 0; group < group_.size(); ++group) {
      flip_group(group);
      if (root_value(side) == start) continue;
      if (group < chosen_) bases_.clear();
      if (group <= chosen_) bases_.push_back({side, group});
      chosen_ = std::min(chosen_, group);
      break;
    }
  }
}

void Neighbourhood::choose_surface() {
  if (chosen_ != not_in_group || group_.empty()) return;
  if (group_.size() == 1) {
    // Its flip is what leads from one side to the other.
    chosen_ = 0;
    bases_ = {{before, 0}, {after, 0}};
    return;
  }
  if (!chosen_by_single_flip()) chosen_by_walk();
  // Only a crossing at which the node does not change gets here without a choice.
  if (chosen_ == not_in_group) chosen_ = 0;
}

Crossing Neighbourhood::bounding_crossing() {
  choose_surface();
  return chosen_ == not_in_group ? crossing_ : group_[chosen_];
}

// The first leaf whose copy of the chosen surface alone, flipped in a base state on one side, changes the result.
std::optional<std::uint32_t> Neighbourhood::first_single_copy(Side side) {
  for (const std::uint32_t slot : owners_) {
    for (const Base& base : bases_) {
      if (base.side != side) continue;
      set_base(base);
      const bool start = root_value(side);
      flip_copy(chosen_, slot);
      if (root_value(side) != start) return slot;
    }
  }
  return std::nullopt;
}

// Among the leaves that own the chosen surface: single copies in the state inside the solid, then in the state outside,
// then walks. LeafIds ascend in file order.
std::uint32_t Neighbourhood::first_slot_by_copies() {
  std::vector<std::uint32_t>& slots = owners_;
  slots.clear();
  for (const Position& position : positions_) {
    if (position.group == chosen_) slots.push_back(position.slot);
  }
  std::sort(slots.begin(), slots.end(), [&](auto a, auto b) { return tree_.leaves()[a] < tree_.leaves()[b]; });
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  if (slots.size() == 1) return slots.front();
  const Side inside = (reset_flips(), root_value(after)) ? after : before;
  if (const auto slot = first_single_copy(inside)) return *slot;
  if (const auto slot = first_single_copy(inside == after ? before : after)) return *slot;
  std::size_t best = slots.size();
  for (const Base& base : bases_) {
    set_base(base);
    const bool start = root_value(base.side);
    for (std::size_t k = 0; k < best; ++k) {
      flip_copy(chosen_, slots[k]);
      if (root_value(base.side) != start) best = k;
    }
  }
  if (best < slots.size()) return slots[best];
  return slots.front();
}

LeafId Neighbourhood::bounding_leaf() {
  choose_surface();
  if (chosen_ != not_in_group) return tree_.leaves()[first_slot_by_copies()];
  // No near leaf owns the surface: culling by plain double roots was off. Any owner is better than none.
  for (std::uint32_t leaf = 0; leaf < scene_.leaves().size(); ++leaf) {
    for (const HalfSpace& half_space : scene_.half_spaces(scene_.leaves()[leaf])) {
      if (half_space.surface == crossing_.surface) return LeafId(leaf);
    }
  }
  return {};
}

LeafId Neighbourhood::holding_leaf(Passage passage) {
  reset_flips();
  root_value(passage == Passage::entry ? after : before);
  return tree_.first_holding_leaf();
}

}  // namespace csgcast::detail
