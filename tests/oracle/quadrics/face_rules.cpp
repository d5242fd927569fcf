// SPDX-License-Identifier: MIT
#include "tests/oracle/quadrics/face_rules.h"

#include <algorithm>
#include <stdexcept>

namespace csgcast::oracle::quadrics {
namespace {

using State = Formula::State;
using Group = std::vector<std::size_t>;

// A state in which a flip of the chosen surface changes the value, and the side of the group that it belongs to.
struct Witness {
  State state;
  bool is_before;
};

struct Choice {
  std::size_t place;  // in the group
  std::vector<Witness> witnesses;
};

bool changes(const Formula& formula, const State& state, std::size_t surface) {
  return formula.value(formula.flipped(state, surface)) != formula.value(state);
}

// Rule 1: the first of the group whose flip alone counts, before or after.
std::optional<Choice> chosen_alone(const Formula& formula, const State& before, const State& after,
                                   const Group& group) {
  for (std::size_t place = 0; place < group.size(); ++place) {
    Choice choice{place, {}};
    if (changes(formula, before, group[place])) choice.witnesses.push_back({before, true});
    if (changes(formula, after, group[place])) choice.witnesses.push_back({after, false});
    if (!choice.witnesses.empty()) return choice;
  }
  return std::nullopt;
}

// Rule 2, one walk: the first flip that counts.
Choice first_of_walk(const Formula& formula, State state, bool is_before, const Group& group) {
  for (std::size_t place = 0; place < group.size(); ++place) {
    if (changes(formula, state, group[place])) return {place, {{state, is_before}}};
    state = formula.flipped(state, group[place]);
  }
  throw std::logic_error("the value does not change across the group");
}

Choice chosen_by_walks(const Formula& formula, const State& before, const State& after, const Group& group) {
  Choice forward = first_of_walk(formula, before, true, group);
  const Choice backward = first_of_walk(formula, after, false, group);
  if (forward.place != backward.place) return forward.place < backward.place ? forward : backward;
  forward.witnesses.push_back(backward.witnesses.front());
  return forward;
}

// The leaves that own a surface, in file order.
std::vector<std::size_t> owners(const Formula& formula, std::size_t surface) {
  std::vector<std::size_t> leaves;
  for (const Copy& copy : formula.copies()) {
    if (copy.surface == surface && (leaves.empty() || leaves.back() != copy.leaf)) leaves.push_back(copy.leaf);
  }
  return leaves;
}

// One leaf's copy alone, in the witnesses on one side.
std::optional<std::size_t> owner_alone(const Formula& formula, const Choice& choice, std::size_t surface,
                                       bool is_before) {
  for (const std::size_t leaf : owners(formula, surface)) {
    for (const Witness& witness : choice.witnesses) {
      if (witness.is_before != is_before) continue;
      if (formula.value(formula.flipped(witness.state, surface, leaf)) != formula.value(witness.state)) return leaf;
    }
  }
  return std::nullopt;
}

// The copies one after the other.
std::size_t owner_by_walk(const Formula& formula, const Choice& choice, std::size_t surface) {
  std::size_t first = formula.leaves().size();
  for (const Witness& witness : choice.witnesses) {
    State state = witness.state;
    for (const std::size_t leaf : owners(formula, surface)) {
      state = formula.flipped(state, surface, leaf);
      if (formula.value(state) == formula.value(witness.state)) continue;
      first = std::min(first, leaf);
      break;
    }
  }
  return first;
}

// Any copy tells the surface's sign.
bool is_positive(const Formula& formula, const State& state, std::size_t surface) {
  const auto& copies = formula.copies();
  const auto copy = std::find_if(copies.begin(), copies.end(), [&](const Copy& c) { return c.surface == surface; });
  return copy->positive == state[static_cast<std::size_t>(copy - copies.begin())];
}

}  // namespace

Face face_at(const Subject& subject, const State& before, const Group& group) {
  const Formula& formula = subject.formula();
  State after = before;
  for (const std::size_t surface : group) after = formula.flipped(std::move(after), surface);
  auto choice = chosen_alone(formula, before, after, group);
  const bool surface_by_walk = !choice;
  if (!choice) choice = chosen_by_walks(formula, before, after, group);
  const std::size_t surface = group[choice->place];
  const bool solid_is_before = formula.value(before);
  auto leaf = owner_alone(formula, *choice, surface, solid_is_before);
  if (!leaf) leaf = owner_alone(formula, *choice, surface, !solid_is_before);
  const bool leaf_by_walk = !leaf;
  if (!leaf) leaf = owner_by_walk(formula, *choice, surface);
  return {surface,         *leaf,        is_positive(formula, before, surface),
          surface_by_walk, leaf_by_walk, formula.first_holder(solid_is_before ? before : after)};
}

}  // namespace csgcast::oracle::quadrics
