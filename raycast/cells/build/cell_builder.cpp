// SPDX-License-Identifier: MIT
#include "raycast/cells/build/cell_builder.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace csgcast::detail {
namespace {

constexpr int most_depth = 60;
// How often a split that promises nothing may be tried on the way down.
constexpr int most_hopes = 3;
constexpr int hopes_of_large = 3;       // so many more where a cell would have no table
constexpr int more_hopes_of_large = 7;  // and as long as a budget lasts
constexpr int hopes_of_crowded = 30;    // and where it would be left to the caster
constexpr std::size_t most_leaves_tried = 12;
constexpr std::size_t most_candidates = 8;
// Parts with so many leaves are built side by side, on so many levels of the tree.
constexpr std::size_t large = 64;
constexpr int deepest_task = 5;
constexpr double least_side = 0x1p-24;
constexpr double least_part = 0.125;  // of a side, that a split cuts off if it promises nothing
// Cells whose area is less than this share of the least leaf's there are not cut: few rays would notice.
constexpr double least_share = 0x1p-9;
constexpr double least_share_of_large = 0x1p-13;

// In turned axes coordinates are off by more, and surfaces are not quite where they are taken to be.
constexpr AxisBounds turned_bounds{0x1p-43, 0x1p-41, 0x1p-10, 0x1p-38};

// The cost of a ray, in units of the test of a surface.
constexpr double cost_of_node = 1.0;
constexpr double cost_of_constant = 0.3;

CellBox below(CellBox box, std::size_t axis, double at) {
  box.upper[axis] = at;
  return box;
}

CellBox above(CellBox box, std::size_t axis, double at) {
  box.lower[axis] = at;
  return box;
}

}  // namespace

double CellBuilder::cost_of_cell(std::size_t surfaces) {
  if (surfaces == 0) return cost_of_constant;
  const double n = static_cast<double>(surfaces);
  return surfaces <= Cell::table_slots ? 1.5 + n : 4 + 2 * n + n * n / 8;
}

CellBuilder::CellBuilder(const CellGround& ground, std::size_t leaves)
    : ground_(ground),
      scene_(ground.scene),
      most_crowded_splits_(2048 + 8 * leaves),
      spare_terms_(32768 + 64 * leaves) {
  const std::size_t surfaces = scene_.surfaces().size();
  asked_in_.assign(surfaces, 0);
  answer_.assign(surfaces, Sides::both);
  seen_in_.assign(surfaces, 0);
  data_.cells.resize(2);  // the two constants
  data_.cells[1].table = 1;
}

CellData CellBuilder::build(NodeId node, const Formula& whole) {
  data_.box = ground_.box;
  data_.reaches_beyond = !ground_.is_bounded;
  data_.is_empty = scene_.node(node).box.is_null() || (whole.is_constant() && !whole.value);
  if (ground_.axes) {
    data_.is_turned = true;
    data_.axes = ground_.axes->rounded();
    data_.axis_bounds = turned_bounds;
  }
  for (const LaneSurface& surface : ground_.surfaces) {
    if (is_axis_cylinder(surface.kind)) data_.has_cylinders[axis_of(surface.kind)] = true;
    if (surface.kind < LaneSurface::Kind::plane) data_.has_axis_planes = true;
    if (!is_plane(surface.kind)) data_.has_quadrics = true;
  }
  if (data_.is_empty) {
    data_.reaches_beyond = false;
    return std::move(data_);
  }
  if (data_.reaches_beyond) {
    build_outside(whole);
  } else {
    if (data_.is_turned) {
      const double unit = std::ldexp(1.0, scene_.frame().exponent);
      data_.half_size = (0.5 * unit) * (data_.box.upper - data_.box.lower);
      data_.middle = Point{} + (0.5 * unit) * (data_.box.upper + data_.box.lower);
    } else {
      const Box& world = scene_.node(node).box;  // has a margin of 2^-30 of its coordinates
      data_.half_size = 0.5 * (world.upper - world.lower);
      data_.middle = world.lower + data_.half_size;
    }
    Formula formula;
    fold(whole, data_.box, formula);
    data_.cost = build({formula}, data_.box, 0, most_hopes);
  }
  return std::move(data_);
}

// Six splits along the sides of the box: each cuts off an infinite cell, and what is left after the last is the box.
void CellBuilder::build_outside(const Formula& whole) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CellBox rest{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  struct Above {
    std::size_t node;
    CellBox box;
    Formula formula;
  };
  std::vector<Above> above_all;  // splits whose other child, the rest, comes first
  Formula formula;
  is_outside_ = true;
  for (std::size_t side = 0; side < 6; ++side) {
    const std::size_t axis = side / 2;
    const bool is_lower = side % 2 == 0;
    const double at = is_lower ? data_.box.lower[axis] : data_.box.upper[axis];
    const std::size_t node = data_.nodes.size();
    data_.nodes.push_back({at, 0, static_cast<std::uint32_t>(axis)});
    const CellBox outer = is_lower ? below(rest, axis, at) : above(rest, axis, at);
    fold(whole, outer, formula);
    if (is_lower) {
      add_cell({formula}, outer);
      data_.nodes[node].above = static_cast<std::uint32_t>(data_.nodes.size());
      rest.lower[axis] = at;
    } else {
      above_all.push_back({node, outer, formula});
      rest.upper[axis] = at;
    }
  }
  is_outside_ = false;
  fold(whole, rest, formula);
  build({formula}, rest, 0, most_hopes);
  is_outside_ = true;
  for (const Above& above : above_all) {
    data_.nodes[above.node].above = static_cast<std::uint32_t>(data_.nodes.size());
    add_cell({above.formula}, above.box);
  }
}

// Whether there is a budget left for one more trial of a formula's splits: where surfaces all but coincide, or the same
// ones come again and again, trials could go on for ever.
bool CellBuilder::spend(const Formula& formula) {
  if (spare_terms_ < formula.terms.size()) return false;
  spare_terms_ -= formula.terms.size();
  return true;
}

// Whether a split since then has the same constant on both sides.
bool CellBuilder::is_one_constant(const Marks& marks) const {
  if (data_.nodes.size() != marks.nodes + 3) return false;
  const CellNode& below = data_.nodes[marks.nodes + 1];
  const CellNode& above = data_.nodes[marks.nodes + 2];
  return below.is_end() && above.is_end() && below.above < 2 && below.above == above.above;
}

void CellBuilder::forget_since(const Marks& marks) {
  data_.nodes.resize(marks.nodes);
  data_.cells.resize(marks.cells);
  data_.slots.resize(marks.slots);
  data_.steps.resize(marks.steps);
}

// The expected cost of the formula's rays if it were one cell.
double CellBuilder::trial_cost(const Formula& formula, const CellBox& box) {
  fold(formula, box, trial_);
  gather_surfaces(trial_, trial_surfaces_);
  return cost_of_cell(trial_surfaces_.size());
}

double CellBuilder::build(const Content& content, const CellBox& box, int depth, int hopes) {
  const Formula& formula = content.formula;
  if (formula.is_constant()) return add_cell(content, box);
  std::vector<SurfaceId> surfaces;
  gather_surfaces(formula, surfaces);
  if (Formula simpler; leave_out_implied(formula, surfaces, box, simpler))
    return build({simpler, content.with_all != nullptr ? content.with_all : &formula}, box, depth, hopes);
  const double as_one = cost_of_cell(surfaces.size());
  if (surfaces.size() < 2 || depth == most_depth) return add_cell(content, box);
  std::vector<LeafId> leaves;
  gather_leaves(formula, leaves);
  const bool is_too_large = surfaces.size() > Cell::table_slots;
  double least = std::numeric_limits<double>::infinity();
  for (const LeafId leaf : leaves) least = std::fmin(least, area(ground_.leaf_boxes[leaf.index()]));
  if (area(box) < least * (is_too_large ? least_share_of_large : least_share)) return add_cell(content, box);
  Split split;
  if (leaves.size() > most_leaves_tried) split = split_by_bins(leaves, box);
  if (split.cost == 0 || split.cost > 0.95 * as_one) {
    constexpr std::size_t most_leaves = 4 * most_leaves_tried;
    // Binning sees boxes only. Where they are of no help, a trial of the real thing is, if it is small enough.
    if (leaves.size() <= most_leaves ||
        (surfaces.size() <= most_leaves && formula.terms.size() <= most_terms_tried && spend(formula)))
      split = split_by_trial(formula, leaves, box);
  }
  const bool is_crowded = surfaces.size() > Cell::most_slots;  // such a cell would be left to the caster
  // One could cut off slivers for ever: what promises nothing has at least to part the box.
  if (split.cost == 0 ? is_crowded : is_too_large && split.cost >= as_one && is_sliver(split, box)) {
    if (const Split half = split_in_half(box); half.cost != 0) split = half;
  }
  if (split.cost == 0) return add_cell(content, box);
  const bool is_promising = split.cost < as_one;
  const int fewest_hopes = is_crowded ? -hopes_of_crowded : is_too_large ? -hopes_of_large : 0;
  if (!is_promising && hopes <= fewest_hopes) {
    const bool is_hopeless = is_crowded || !is_too_large || hopes <= fewest_hopes - more_hopes_of_large;
    if (is_hopeless || !spend(formula)) return add_cell(content, box);
  }
  // Where surfaces crowd in more than a place, splits could go on for ever.
  if (!is_promising && is_crowded && crowded_splits_++ > most_crowded_splits_) return add_cell(content, box);
  const int left = is_promising ? most_hopes : hopes - 1;

  const Marks before = marks();
  const double cost = build_parts(content, box, split, leaves.size(), depth, left);
  if (is_one_constant(before)) {
    const CellNode end = data_.nodes.back();
    forget_since(before);
    data_.nodes.push_back(end);
    return cost_of_cell(0);
  }
  if (cost < as_one || is_crowded) return cost;
  forget_since(before);
  return add_cell(content, box);
}

// The two sides of a split, side by side if they are large.
double CellBuilder::build_parts(const Content& content, const CellBox& box, const Split& split, std::size_t leaves,
                                int depth, int hopes) {
  const std::size_t node = data_.nodes.size();
  data_.nodes.push_back({split.at, 0, static_cast<std::uint32_t>(split.axis)});
  const std::array<CellBox, 2> parts{below(box, split.axis, split.at), above(box, split.axis, split.at)};
  const std::array<double, 2> share{area(parts[0]) / area(box), area(parts[1]) / area(box)};
  Formula folded;
  if (leaves < large || is_outside_ || depth > deepest_task) {
    fold(content.formula, parts[0], folded);
    double cost = cost_of_node + share[0] * build({folded, content.with_all}, parts[0], depth + 1, hopes);
    data_.nodes[node].above = static_cast<std::uint32_t>(data_.nodes.size());
    fold(content.formula, parts[1], folded);
    cost += share[1] * build({folded, content.with_all}, parts[1], depth + 1, hopes);
    return cost;
  }
  std::array<double, 2> costs{};
  std::array<CellData, 2> built;
  const auto build_part = [&](std::size_t part) {
    CellBuilder builder(ground_, leaves);
    Formula own;
    builder.fold(content.formula, parts[part], own);
    costs[part] = builder.build({own, content.with_all}, parts[part], depth + 1, hopes);
    built[part] = std::move(builder.data_);
  };
  tbb::parallel_invoke([&] { build_part(0); }, [&] { build_part(1); });
  append(std::move(built[0]));
  data_.nodes[node].above = static_cast<std::uint32_t>(data_.nodes.size());
  append(std::move(built[1]));
  return cost_of_node + share[0] * costs[0] + share[1] * costs[1];
}

// Puts what another builder made behind what is there; both have the two constant cells in front.
void CellBuilder::append(CellData&& part) {
  const auto nodes = static_cast<std::uint32_t>(data_.nodes.size());
  const auto cells = static_cast<std::uint32_t>(data_.cells.size()) - 2;
  const auto slots = static_cast<std::uint32_t>(data_.slots.size());
  const auto steps = static_cast<std::uint32_t>(data_.steps.size());
  for (CellNode& node : part.nodes) {
    if (!node.is_end()) {
      node.above += nodes;
    } else if (node.above >= 2) {
      node.above += cells;
      node.set_first_slot(node.first_slot() + slots);
    }
  }
  for (Cell& cell : part.cells) {
    cell.first_slot += slots;
    cell.first_step += steps;
  }
  data_.nodes.insert(data_.nodes.end(), part.nodes.begin(), part.nodes.end());
  data_.cells.insert(data_.cells.end(), part.cells.begin() + 2, part.cells.end());
  data_.slots.insert(data_.slots.end(), part.slots.begin(), part.slots.end());
  data_.steps.insert(data_.steps.end(), part.steps.begin(), part.steps.end());
}

bool CellBuilder::is_sliver(const Split& split, const CellBox& box) {
  const double low = box.lower[split.axis], high = box.upper[split.axis];
  return std::fmin(split.at - low, high - split.at) < least_part * (high - low);
}

CellBuilder::Split CellBuilder::split_in_half(const CellBox& box) {
  const Vector size = box.upper - box.lower;
  const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  if (!(size[axis] > 2 * least_side)) return {};
  return {axis, 0.5 * (box.lower[axis] + box.upper[axis]), HUGE_VAL};
}

// The surface area heuristic over the boxes of the leaves.
CellBuilder::Split CellBuilder::split_by_bins(std::span<const LeafId> leaves, const CellBox& box) const {
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
      ++begins[bin(ground_.leaf_boxes[leaf.index()].lower[axis] - beside)];
      ++ends[bin(ground_.leaf_boxes[leaf.index()].upper[axis] + beside)];
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
  if (std::isinf(best.cost)) return {};
  return best;
}

// Candidates beside the leaves' sides and in the middle, in the order of axes and places, none twice.
void CellBuilder::find_candidates(std::span<const LeafId> leaves, const CellBox& box) {
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
        add(side - beside);
        add(side + beside);
      }
    }
    std::sort(places_.begin(), places_.end());
    const auto last =
        std::unique(places_.begin(), places_.end(), [](double a, double b) { return b - a < beside / 2; });
    std::for_each(places_.begin(), last, [&](double at) { candidates_.push_back({axis, at, 0}); });
  }
}

// The best of some candidates, by what the children would really be.
CellBuilder::Split CellBuilder::split_by_trial(const Formula& formula, std::span<const LeafId> leaves,
                                               const CellBox& box) {
  find_candidates(leaves, box);
  const std::size_t stride = (candidates_.size() + most_candidates - 1) / most_candidates;
  Split best{};
  for (std::size_t i = 0; i < candidates_.size(); i += std::max<std::size_t>(stride, 1)) {
    Split split = candidates_[i];
    const std::array<CellBox, 2> parts{below(box, split.axis, split.at), above(box, split.axis, split.at)};
    const std::array<double, 2> areas{area(parts[0]), area(parts[1])};
    std::array<double, 2> costs{cost_of_constant, cost_of_constant};  // at least
    const auto cost = [&] { return cost_of_node + (areas[0] * costs[0] + areas[1] * costs[1]) / area(box); };
    // The larger part alone often costs more than the best split so far.
    const std::size_t larger = areas[1] > areas[0] ? 1 : 0;
    for (const std::size_t part : {larger, 1 - larger}) {
      costs[part] = trial_cost(formula, parts[part]);
      split.cost = cost();
      if (best.cost != 0 && split.cost >= best.cost) break;
    }
    if (best.cost == 0 || split.cost < best.cost) best = split;
  }
  return best;
}

}  // namespace csgcast::detail
