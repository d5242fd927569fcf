// SPDX-License-Identifier: MIT
#include "raycast/cells/build/detail/split_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "raycast/cells/build/cell_box.h"
#include "raycast/cells/build/cell_data.h"
#include "raycast/cells/build/detail/cell_cost.h"

namespace csgcast::detail {
namespace {

constexpr int hopes_of_large = 3;       // additional hopes where a cell would have no table
constexpr int more_hopes_of_large = 7;  // additional hopes as long as a budget lasts
constexpr int hopes_of_crowded = 30;    // additional hopes where a cell would be left to the caster
// A box with at most this many leaves is split by trial, without examining the boxes of the leaves first.
constexpr std::size_t most_leaves_tried = 12;
// With more leaves, more surfaces or longer formulas a trial takes too long.
constexpr std::size_t most_leaves = 4 * most_leaves_tried;
constexpr std::size_t most_terms = 2048;
constexpr std::size_t most_candidates = 8;
// If a split does not cost less than this share of one cell, a better one is searched by trial.
constexpr double good_share = 0.95;
constexpr double least_side = 0x1p-24;
// A split that promises nothing must cut off at least this share of a side, because slivers could be cut off for ever.
constexpr double least_part = 0.125;
// Boxes whose area is less than this share of the area of the smallest leaf there are not split, because few rays meet
// them.
constexpr double least_share = 0x1p-9;
constexpr double least_share_of_large = 0x1p-13;

// True for a cell without a table.
bool is_large(std::size_t surfaces) { return surfaces > Cell::table_slots; }
// True for a cell that would be left to the caster.
bool is_crowded(std::size_t surfaces) { return surfaces > Cell::most_slots; }

bool is_sliver(const Split& split, const CellBox& box) {
  const double low = box.lower[split.axis], high = box.upper[split.axis];
  return std::fmin(split.at - low, high - split.at) < least_part * (high - low);
}

// Splits the longest side in the middle, without regard to cost.
std::optional<Split> in_half(const CellBox& box) {
  const Vector size = box.upper - box.lower;
  const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  if (!(size[axis] > 2 * least_side)) return std::nullopt;
  return Split{axis, 0.5 * (box.lower[axis] + box.upper[axis]), HUGE_VAL};
}

}  // namespace

SplitSearch::SplitSearch(const CellGround& ground, BoxFold& fold, std::size_t leaves)
    : ground_(ground),
      fold_(fold),
      most_crowded_splits_(2048 + 8 * leaves),
      spare_terms_(32768 + 64 * leaves),
      trial_surfaces_(ground.forms.size()) {}

std::optional<SplitSearch::Found> SplitSearch::find(const Formula& formula, std::span<const LeafId> leaves,
                                                    std::size_t surfaces, const CellBox& box, int hopes) {
  if (is_too_small(leaves, is_large(surfaces), box)) return std::nullopt;
  const std::optional<Split> split = best(formula, leaves, surfaces, box);
  if (!split) return std::nullopt;
  if (split->cost < cost_of_cell(surfaces)) return Found{*split, most_hopes};
  if (!may_hope(formula, surfaces, hopes)) return std::nullopt;
  return Found{*split, hopes - 1};
}

bool SplitSearch::is_too_small(std::span<const LeafId> leaves, bool is_large, const CellBox& box) const {
  double least = std::numeric_limits<double>::infinity();
  for (const LeafId leaf : leaves) least = std::fmin(least, area(ground_.leaf_boxes[leaf.index()]));
  return area(box) < least * (is_large ? least_share_of_large : least_share);
}

std::optional<Split> SplitSearch::best(const Formula& formula, std::span<const LeafId> leaves, std::size_t surfaces,
                                       const CellBox& box) {
  const double as_one = cost_of_cell(surfaces);
  std::optional<Split> split;
  if (leaves.size() > most_leaves_tried) split = by_bins(leaves, box);
  if (!split || split->cost > good_share * as_one) {
    // Binning sees only boxes. If they do not help, a trial with the formula does, if the formula is small enough.
    if (leaves.size() <= most_leaves ||
        (surfaces <= most_leaves && formula.terms.size() <= most_terms && spend(formula)))
      split = by_trial(formula, leaves, box);
  }
  const bool is_in_vain =
      split ? is_large(surfaces) && split->cost >= as_one && is_sliver(*split, box) : is_crowded(surfaces);
  if (is_in_vain) {
    if (const std::optional<Split> half = in_half(box)) split = half;
  }
  return split;
}

// Tells if a split that promises nothing may be made nevertheless.
bool SplitSearch::may_hope(const Formula& formula, std::size_t surfaces, int hopes) {
  // If surfaces crowd in more than one place, splits could go on for ever.
  if (is_crowded(surfaces)) return hopes > -hopes_of_crowded && crowded_splits_++ <= most_crowded_splits_;
  if (!is_large(surfaces)) return hopes > 0;
  return hopes > -hopes_of_large || (hopes > -hopes_of_large - more_hopes_of_large && spend(formula));
}

// Takes one more trial of a formula from the budget. Returns false if too little is left. Without a budget, trials
// could go on for ever where surfaces nearly coincide, or the same ones occur again and again.
bool SplitSearch::spend(const Formula& formula) {
  if (spare_terms_ < formula.terms.size()) return false;
  spare_terms_ -= formula.terms.size();
  return true;
}

// Searches by the surface area heuristic over the boxes of the leaves.
std::optional<Split> SplitSearch::by_bins(std::span<const LeafId> leaves, const CellBox& box) const {
  constexpr std::size_t bins = 32;
  Split best{0, 0, std::numeric_limits<double>::infinity()};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = box.lower[axis];
    const double width = (box.upper[axis] - low) / bins;
    if (width < least_side) continue;
    std::array<std::uint32_t, bins + 1> begins{};
    std::array<std::uint32_t, bins + 1> ends{};
    const auto bin = [&](double x) {
      return static_cast<std::size_t>(std::clamp((x - low) / width, 0.0, static_cast<double>(bins) - 0.5));
    };
    for (const LeafId leaf : leaves) {
      ++begins[bin(ground_.leaf_boxes[leaf.index()].lower[axis] - face_clearance)];
      ++ends[bin(ground_.leaf_boxes[leaf.index()].upper[axis] + face_clearance)];
    }
    std::size_t left = 0;
    std::size_t right = leaves.size();
    for (std::size_t i = 1; i < bins; ++i) {
      left += begins[i - 1];
      right -= ends[i - 1];
      const double at = low + static_cast<double>(i) * width;
      const double cost = cost_of_node + (area(below(box, axis, at)) * cost_of_cell(left) +
                                          area(above(box, axis, at)) * cost_of_cell(right)) /
                                             area(box);
      if (cost < best.cost) best = {axis, at, cost};
    }
  }
  if (std::isinf(best.cost)) return std::nullopt;
  return best;
}

// Finds candidates beside the leaves' sides and in the middle, by axis and then by place, none of them twice.
void SplitSearch::find_candidates(std::span<const LeafId> leaves, const CellBox& box) {
  candidates_.clear();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = box.lower[axis];
    const double high = box.upper[axis];
    if (high - low < 2 * least_side) continue;
    places_.clear();
    const auto add = [&](double at) {
      if (at > low + least_side && at < high - least_side) places_.push_back(at);
    };
    add(0.5 * (low + high));
    for (const LeafId leaf : leaves) {
      const CellBox& around = ground_.leaf_boxes[leaf.index()];
      for (const double side : {around.lower[axis], around.upper[axis]}) {
        add(side - face_clearance);
        add(side + face_clearance);
      }
    }
    std::sort(places_.begin(), places_.end());
    const auto last =
        std::unique(places_.begin(), places_.end(), [](double a, double b) { return b - a < face_clearance / 2; });
    std::for_each(places_.begin(), last, [&](double at) { candidates_.push_back({axis, at, 0}); });
  }
}

// Finds the best of some candidates, by the real cost of the two parts.
std::optional<Split> SplitSearch::by_trial(const Formula& formula, std::span<const LeafId> leaves, const CellBox& box) {
  find_candidates(leaves, box);
  const std::size_t stride = (candidates_.size() + most_candidates - 1) / most_candidates;
  std::optional<Split> best;
  for (std::size_t i = 0; i < candidates_.size(); i += std::max<std::size_t>(stride, 1)) {
    Split split = candidates_[i];
    const std::array<CellBox, 2> parts{below(box, split.axis, split.at), above(box, split.axis, split.at)};
    const std::array<double, 2> areas{area(parts[0]), area(parts[1])};
    std::array<double, 2> costs{cost_of_constant, cost_of_constant};  // lower bounds
    const auto cost = [&] { return cost_of_node + (areas[0] * costs[0] + areas[1] * costs[1]) / area(box); };
    // The larger part alone often costs more than the best split found so far.
    const std::size_t larger = areas[1] > areas[0] ? 1 : 0;
    for (const std::size_t part : {larger, 1 - larger}) {
      costs[part] = trial_cost(formula, parts[part]);
      split.cost = cost();
      if (best && split.cost >= best->cost) break;
    }
    if (!best || split.cost < best->cost) best = split;
  }
  return best;
}

// The expected cost of rays through a box, if it were one cell.
double SplitSearch::trial_cost(const Formula& formula, const CellBox& box) {
  fold_.fold(formula, box, trial_);
  trial_surfaces_.gather(trial_);
  return cost_of_cell(ground_.burden(trial_surfaces_));
}

}  // namespace csgcast::detail
