// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "csg/base/length.h"
#include "raycast/ray/caster.h"
#include "raycast/ray/detail/caster_state.h"

// Point membership: exact signs of the surfaces near the point, and every choice of those that are zero.

namespace csgcast {
namespace {

// One half-space of a near leaf: the sign of its surface at the point, as the half-space sees it.
struct Position {
  std::uint32_t slot;
  bool wants_positive;
  int sign;
  std::uint32_t choice;  // index of the surface among those that are zero
};

// Decides a tree near a point whose undecided surfaces may be on either side, by branching on them one by one.
class ChoiceSearch {
 public:
  ChoiceSearch(detail::LocalTree& tree, std::vector<Position> positions, std::size_t choices)
      : tree_(tree), positions_(std::move(positions)), sign_(choices, 0), leaf_truth_(tree.leaves().size()) {}

  // Inside (outside) if every choice of signs gives it. Past the budget, as for hundreds of facets through one point,
  // the safe answer: boundary.
  Location run() {
    std::vector<std::uint32_t> open;  // the choices made, in order; each tries negative, then positive
    bool found_inside = false;
    bool found_outside = false;
    for (int budget = 4096; budget > 0; --budget) {
      const std::uint32_t next = evaluate();
      if (value_ == detail::Truth::unknown) {
        sign_[next] = -1;
        open.push_back(next);
        continue;
      }
      (value_ == detail::Truth::yes ? found_inside : found_outside) = true;
      if (found_inside && found_outside) return Location::boundary;
      while (!open.empty() && sign_[open.back()] == 1) {
        sign_[open.back()] = 0;
        open.pop_back();
      }
      if (open.empty()) return found_inside ? Location::inside : Location::outside;
      sign_[open.back()] = 1;
    }
    return Location::boundary;
  }

 private:
  // Sets value_ under the signs chosen so far; returns a surface that is still open in an undecided leaf.
  std::uint32_t evaluate() {
    std::fill(leaf_truth_.begin(), leaf_truth_.end(), detail::Truth::yes);
    std::uint32_t next = 0;
    for (const Position& position : positions_) {
      detail::Truth& leaf = leaf_truth_[position.slot];
      const int sign = position.sign != 0 ? position.sign : sign_[position.choice];
      const detail::Truth holds =
          sign == 0 ? detail::Truth::unknown : detail::truth((sign > 0) == position.wants_positive);
      leaf = std::min(leaf, holds);
    }
    value_ = tree_.evaluate(leaf_truth_);
    for (const Position& position : positions_) {
      const bool undecided = leaf_truth_[position.slot] == detail::Truth::unknown;
      if (undecided && position.sign == 0 && sign_[position.choice] == 0) next = position.choice;
    }
    return next;
  }

  detail::LocalTree& tree_;
  std::vector<Position> positions_;
  std::vector<int> sign_;
  std::vector<detail::Truth> leaf_truth_;
  detail::Truth value_ = detail::Truth::unknown;
};

}  // namespace

Location Caster::locate(NodeId node, Point p) {
  State& state = *state_;
  const Scene& scene = state.scene;
  if (!is_finite(p)) {
    throw Error(ErrorCode::bad_value, {}, "a point needs three finite numbers",
                "no other place can be inside or outside", "check its coordinates");
  }
  state.near_point.build(scene, node, [&](const Box& box) { return box.contains(p); });
  std::vector<Position> positions;
  std::vector<SurfaceId> zero;
  for (std::uint32_t slot = 0; slot < state.near_point.leaves().size(); ++slot) {
    for (const HalfSpace& half_space : scene.half_spaces(scene.leaf(state.near_point.leaves()[slot]))) {
      const int sign = sign_at(scene.surface(half_space.surface), p);
      const auto known = std::find(zero.begin(), zero.end(), half_space.surface);
      positions.push_back(
          {slot, half_space.sense == Sense::positive, sign, static_cast<std::uint32_t>(known - zero.begin())});
      if (sign == 0 && known == zero.end()) zero.push_back(half_space.surface);
    }
  }
  return ChoiceSearch(state.near_point, std::move(positions), zero.size()).run();
}

PartId Caster::part_at(Point p) {
  for (std::uint32_t i = 0; i < scene().parts().size(); ++i) {
    if (locate(scene().parts()[i].node, p) == Location::inside) return PartId(i);
  }
  return {};
}

}  // namespace csgcast
