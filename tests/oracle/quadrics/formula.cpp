// SPDX-License-Identifier: MIT
#include "tests/oracle/quadrics/formula.h"

#include <algorithm>
#include <utility>

#include "csg/solid/leaf_shape.h"

namespace csgcast::oracle::quadrics {
namespace {

using Kind = Solid::Kind;

constexpr std::size_t no_parent = static_cast<std::size_t>(-1);

// Whether a child is taken away from what stands above its parent.
bool is_cut_away(Kind parent, std::size_t child) {
  return parent == Kind::complement || (parent == Kind::subtract && child > 0);
}

}  // namespace

// A solid still to be visited, and what stands above it.
struct Formula::Visit {
  Solid solid;
  SolidFromWorld map;
  LookContext looks;
  std::string part;
  std::size_t parent = no_parent;
  bool is_first_child = true;
  bool negative = false;
  bool subtracted = false;
  bool look_since_cut = false;
};

Formula::Formula(const Solid& solid) {
  std::vector<Visit> open(1);
  open.back().solid = solid;
  while (!open.empty()) {
    const Visit visit = std::move(open.back());
    open.pop_back();
    const Kind kind = visit.solid.kind();
    has_no_constants_ = has_no_constants_ && kind != Kind::empty && kind != Kind::everything;
    nodes_.push_back({kind, visit.parent, visit.is_first_child, leaves_.size()});
    if (kind == Kind::leaf) add_leaf(visit);
    for (std::size_t child = visit.solid.children().size(); child-- > 0;) {
      open.push_back(below(visit, child, nodes_.size() - 1));
    }
  }
}

Formula::Visit Formula::below(const Visit& visit, std::size_t child, std::size_t node) {
  Visit result = visit;
  result.solid = visit.solid.children()[child];
  result.parent = node;
  result.is_first_child = child == 0;
  if (is_cut_away(visit.solid.kind(), child)) {
    result.negative = !visit.negative;
    result.subtracted = true;
  } else if (visit.solid.kind() == Kind::transform) {
    result.map = visit.map.inside(visit.solid.transform());
  } else if (visit.solid.kind() == Kind::part) {
    result.part = visit.solid.part().name;
  } else if (visit.solid.kind() == Kind::look) {
    result.looks = visit.looks.with(visit.solid.look());
    result.look_since_cut = visit.subtracted;
  }
  return result;
}

void Formula::add_leaf(const Visit& visit) {
  FormulaLeaf leaf;
  leaf.first = copies_.size();
  leaf.part = visit.part;
  leaf.look = visit.looks.resolve();
  leaf.subtracted = visit.subtracted;
  leaf.shows_cut = visit.negative && !visit.look_since_cut;
  for (const QuadricForm& form : visit.solid.shape().forms) {
    const RationalForm world = visit.map.pulled_back(RationalForm(form));
    copies_.push_back({index_of(world.normalised()), leaves_.size(), world.leading_sign() < 0});
  }
  leaf.end = copies_.size();
  leaves_.push_back(std::move(leaf));
}

std::size_t Formula::index_of(const RationalForm& normalised) {
  const auto [place, is_new] = index_.try_emplace(normalised, surfaces_.size());
  if (is_new) surfaces_.push_back(normalised);
  return place->second;
}

bool Formula::holds(const FormulaLeaf& leaf, const State& state) const {
  const auto begin = state.begin();
  return std::all_of(begin + static_cast<std::ptrdiff_t>(leaf.first), begin + static_cast<std::ptrdiff_t>(leaf.end),
                     [](bool copy) { return copy; });
}

std::vector<bool> Formula::values(const State& state) const {
  std::vector<bool> values;  // until its children are done: what those that are leave of a node
  for (const FormulaNode& node : nodes_) {
    const bool all = node.kind != Kind::unite && node.kind != Kind::empty;
    values.push_back(node.kind == Kind::leaf ? holds(leaves_[node.leaf], state) : all);
  }
  for (std::size_t i = nodes_.size(); i-- > 1;) {
    const FormulaNode& node = nodes_[i];
    const Kind parent = nodes_[node.parent].kind;
    const bool counts = values[i] != is_cut_away(parent, node.is_first_child ? 0 : 1);
    values[node.parent] = parent == Kind::unite ? values[node.parent] || counts : values[node.parent] && counts;
  }
  return values;
}

std::optional<std::size_t> Formula::first_holder(const State& state) const {
  std::vector<bool> active = values(state);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const FormulaNode& node = nodes_[i];
    active[i] = active[i] && (node.parent == no_parent || active[node.parent]);
    if (active[i] && node.kind == Kind::leaf && !leaves_[node.leaf].subtracted) return node.leaf;
  }
  return std::nullopt;
}

Formula::State Formula::flipped(State state, std::size_t surface) const {
  for (std::size_t i = 0; i < copies_.size(); ++i) {
    if (copies_[i].surface == surface) state[i] = !state[i];
  }
  return state;
}

Formula::State Formula::flipped(State state, std::size_t surface, std::size_t leaf) const {
  for (std::size_t i = leaves_[leaf].first; i < leaves_[leaf].end; ++i) {
    if (copies_[i].surface == surface) state[i] = !state[i];
  }
  return state;
}

}  // namespace csgcast::oracle::quadrics
