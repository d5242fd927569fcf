// SPDX-License-Identifier: MIT
#include "raycast/ray/detail/choice_search.h"

#include <algorithm>

#include "raycast/scene/leaf_function.h"

namespace csgcast::detail {

void ChoiceSearch::clear() {
  positions_.clear();
  functions_.clear();
  surfaces_.clear();
}

void ChoiceSearch::add(std::uint32_t slot, const HalfSpace& half_space, int sign) {
  std::uint32_t choice = 0;
  if (sign == 0) {
    const auto known = std::find(surfaces_.begin(), surfaces_.end(), half_space.surface);
    choice = static_cast<std::uint32_t>(known - surfaces_.begin());
    if (known == surfaces_.end()) surfaces_.push_back(half_space.surface);
  }
  positions_.push_back({slot, half_space.sense == Sense::positive, sign, choice});
}

void ChoiceSearch::set_function(std::uint32_t slot, const LeafFunction& function, std::size_t half_spaces) {
  functions_.push_back({slot, &function, positions_.size() - half_spaces, positions_.size()});
}

Location ChoiceSearch::run(LocalTree& tree) {
  constexpr int most_steps = 4096;
  chosen_.assign(surfaces_.size(), 0);
  order_.clear();
  bool found_inside = false;
  bool found_outside = false;
  for (int step = 0; step < most_steps; ++step) {
    const Truth value = evaluate(tree);
    if (value == Truth::unknown) {
      order_.push_back(next_choice());
      chosen_[order_.back()] = -1;
      continue;
    }
    (value == Truth::yes ? found_inside : found_outside) = true;
    if (found_inside && found_outside) return Location::boundary;
    if (!turn_last_choice()) return found_inside ? Location::inside : Location::outside;
  }
  return Location::boundary;
}

Truth ChoiceSearch::holds(const Position& position) const {
  const int sign = sign_of(position);
  return sign == 0 ? Truth::unknown : truth((sign > 0) == position.wants_positive);
}

// The tree's value under the choices made so far.
Truth ChoiceSearch::evaluate(LocalTree& tree) {
  leaf_truth_.assign(tree.leaves().size(), Truth::yes);
  for (const Position& position : positions_)
    leaf_truth_[position.slot] = std::min(leaf_truth_[position.slot], holds(position));
  for (const FunctionLeaf& leaf : functions_) {
    holds_.clear();
    for (std::size_t i = leaf.first; i < leaf.end; ++i) holds_.push_back(holds(positions_[i]));
    leaf_truth_[leaf.slot] = leaf.function->value(holds_);
  }
  return tree.evaluate(leaf_truth_);
}

// Finds a surface that has no choice yet and belongs to a leaf that is not decided. Precondition: the tree is not
// decided.
std::uint32_t ChoiceSearch::next_choice() const {
  std::uint32_t next = 0;
  for (const Position& position : positions_) {
    if (leaf_truth_[position.slot] == Truth::unknown && sign_of(position) == 0) next = position.choice;
  }
  return next;
}

// Goes back to the last choice for which only the negative sign was tried, and makes it positive. False if there is
// none.
bool ChoiceSearch::turn_last_choice() {
  while (!order_.empty() && chosen_[order_.back()] == 1) {
    chosen_[order_.back()] = 0;
    order_.pop_back();
  }
  if (order_.empty()) return false;
  chosen_[order_.back()] = 1;
  return true;
}

}  // namespace csgcast::detail
