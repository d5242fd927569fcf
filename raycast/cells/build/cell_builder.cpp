// SPDX-License-Identifier: MIT
#include "raycast/cells/build/cell_builder.h"

#include <tbb/parallel_invoke.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "raycast/cells/build/box_fold.h"
#include "raycast/cells/build/cell_box.h"
#include "raycast/cells/build/detail/cell_cost.h"
#include "raycast/cells/build/detail/cell_maker.h"
#include "raycast/cells/build/detail/cell_tree.h"
#include "raycast/cells/build/detail/split_search.h"
#include "raycast/cells/formula/implications.h"
#include "raycast/cells/formula/implied_fold.h"
#include "raycast/cells/formula/surface_set.h"

namespace csgcast::detail {
namespace {

constexpr int most_depth = 60;
// The halves of a part with at least this many leaves are built side by side, on at most this many levels of the tree.
constexpr std::size_t large = 64;
constexpr int deepest_task = 5;

// In turned axes coordinates have larger errors, and surfaces are not exactly where they are assumed to be.
constexpr AxisBounds turned_bounds{0x1p-43, 0x1p-41, 0x1p-10, 0x1p-38};

// Builds the kd-tree of one box with all its cells. Working memory of one thread.
class CellBuilder {
 public:
  // `leaves` is an upper bound on the number of leaves. It limits the number of futile trials.
  CellBuilder(const CellGround& ground, std::size_t leaves)
      : ground_(ground),
        fold_(ground, BoxFold::Places::of_rays),
        maker_(ground, fold_, tree_),
        search_(ground, fold_, leaves),
        surfaces_(ground.forms.size()) {}
  CellBuilder(const CellBuilder&) = delete;
  CellBuilder& operator=(const CellBuilder&) = delete;

  // Adds the tree of a box, and returns the expected cost of a ray through it.
  double build_inside(const Formula& whole, const CellBox& box);
  // Adds the tree of all of space, with the tree of a box in the middle.
  void build_everywhere(const Formula& whole, const CellBox& box);
  CellTree& tree() { return tree_; }

 private:
  // A box to be built.
  struct Part {
    CellContent content;  // folded in the box
    CellBox box;
    int depth = 0;
    int hopes = SplitSearch::most_hopes;
  };

  double build(const Part& part);
  double build_halves(const Part& part, const SplitSearch::Found& found, std::size_t leaves);
  bool leave_out_implied(const Formula& formula, const CellBox& box, Formula& simpler);

  const CellGround& ground_;
  CellTree tree_;
  BoxFold fold_;
  CellMaker maker_;
  SplitSearch search_;
  SurfaceSet surfaces_;
  Implications implications_;
  ImpliedFold implied_fold_;
};

double CellBuilder::build_inside(const Formula& whole, const CellBox& box) {
  Formula formula;
  fold_.fold(whole, box, formula);
  return build({{formula}, box});
}

// Makes six splits along the sides of the box. Each cuts off an infinite cell. What is left after the last split is the
// box.
void CellBuilder::build_everywhere(const Formula& whole, const CellBox& box) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CellBox rest{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  struct Above {
    std::size_t split;
    CellBox box;
    Formula formula;
  };
  std::vector<Above> above_all;  // the splits whose lower child, the rest, comes first
  Formula formula;
  for (std::size_t side = 0; side < 6; ++side) {
    const std::size_t axis = side / 2;
    const bool is_lower = side % 2 == 0;
    const double at = is_lower ? box.lower[axis] : box.upper[axis];
    const std::size_t split = tree_.add_split(axis, at);
    const CellBox outer = is_lower ? below(rest, axis, at) : above(rest, axis, at);
    fold_.fold(whole, outer, formula);
    if (is_lower) {
      maker_.add({formula}, outer);
      tree_.begin_above(split);
      rest = above(rest, axis, at);
    } else {
      above_all.push_back({split, outer, formula});
      rest = below(rest, axis, at);
    }
  }
  build_inside(whole, rest);
  for (const Above& above : above_all) {
    tree_.begin_above(above.split);
    maker_.add({above.formula}, above.box);
  }
}

// Builds a part, and returns the expected cost of a ray through it.
double CellBuilder::build(const Part& part) {
  const auto& [content, box, depth, hopes] = part;
  const Formula& formula = content.formula;
  if (formula.is_constant()) return maker_.add(content, box);
  surfaces_.gather(formula);
  if (Formula simpler; leave_out_implied(formula, box, simpler))
    return build({{simpler, content.with_all != nullptr ? content.with_all : &formula}, box, depth, hopes});
  const std::size_t surfaces = ground_.burden(surfaces_);
  if (surfaces < 2 || depth == most_depth) return maker_.add(content, box);
  std::vector<LeafId> leaves;
  for (const Term& term : formula.terms) {
    if (term.op == Term::Op::leaf) leaves.emplace_back(term.what);
  }
  const std::optional<SplitSearch::Found> found = search_.find(formula, leaves, surfaces, box, hopes);
  if (!found) return maker_.add(content, box);

  const CellTree::Mark before = tree_.mark();
  const double cost = build_halves(part, *found, leaves.size());
  if (tree_.merge_constant(before)) return cost_of_cell(0);
  const bool is_crowded = surfaces > Cell::most_slots;  // a single cell would be left to the caster
  if (cost < cost_of_cell(surfaces) || is_crowded) return cost;
  tree_.return_to(before);
  return maker_.add(content, box);
}

// Builds the two sides of a split. If they are large, they are built side by side.
double CellBuilder::build_halves(const Part& part, const SplitSearch::Found& found, std::size_t leaves) {
  const CellContent& content = part.content;
  const CellBox& box = part.box;
  const int depth = part.depth + 1;
  const Split& split = found.split;
  const std::size_t node = tree_.add_split(split.axis, split.at);
  const std::array<CellBox, 2> halves{below(box, split.axis, split.at), above(box, split.axis, split.at)};
  const std::array<double, 2> share{area(halves[0]) / area(box), area(halves[1]) / area(box)};
  if (leaves < large || part.depth > deepest_task) {
    Formula folded;
    fold_.fold(content.formula, halves[0], folded);
    double cost = cost_of_node + share[0] * build({{folded, content.with_all}, halves[0], depth, found.hopes});
    tree_.begin_above(node);
    fold_.fold(content.formula, halves[1], folded);
    cost += share[1] * build({{folded, content.with_all}, halves[1], depth, found.hopes});
    return cost;
  }
  std::array<double, 2> costs{};
  std::array<CellTree, 2> trees;
  const auto build_half = [&](std::size_t half) {
    CellBuilder builder(ground_, leaves);
    Formula folded;
    builder.fold_.fold(content.formula, halves[half], folded);
    costs[half] = builder.build({{folded, content.with_all}, halves[half], depth, found.hopes});
    trees[half] = std::move(builder.tree_);
  };
  tbb::parallel_invoke([&] { build_half(0); }, [&] { build_half(1); });
  tree_.append(std::move(trees[0]));
  tree_.begin_above(node);
  tree_.append(std::move(trees[1]));
  return cost_of_node + share[0] * costs[0] + share[1] * costs[1];
}

// Makes `simpler` the formula without what its other surfaces, as gathered last, imply in the box. Returns false if
// nothing is implied.
bool CellBuilder::leave_out_implied(const Formula& formula, const CellBox& box, Formula& simpler) {
  if (!ImpliedFold::is_worthwhile(formula, surfaces_)) return false;
  const CellBox wide = inflated(box);
  const Vector half = 0.5 * (wide.upper - wide.lower);
  implications_.begin(surfaces_.size(), half);
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const std::size_t surface = surfaces_[i].index();
    if (ground_.surfaces[surface].kind == LaneSurface::Kind::undecided) continue;
    LocalForm form = ground_.form_in(surface, wide);
    // A ray that departs from a surface is on the side that it departs to, even if its computed start is not exactly
    // there.
    form.slack += cell_margin * steepness(form, half);
    implications_.add(i, form);
  }
  return implied_fold_.fold(formula, surfaces_, implications_, simpler);
}

// Describes what is known of the cells before any is built.
CellData describe(const CellGround& ground, NodeId node, const Formula& whole) {
  const Scene& scene = ground.scene;
  const Box& world = scene.node(node).box;  // this has a margin of 2^-30 of its coordinates
  CellData data;
  data.box = ground.box;
  data.is_empty = world.is_null() || (whole.is_constant() && !whole.value);
  data.reaches_beyond = !ground.is_bounded && !data.is_empty;
  if (ground.axes) {
    data.is_turned = true;
    data.axes = ground.axes->rounded();
    data.axis_bounds = turned_bounds;
  }
  for (const LaneSurface& surface : ground.surfaces) {
    if (is_axis_cylinder(surface.kind)) data.has_cylinders[axis_of(surface.kind)] = true;
    if (surface.kind < LaneSurface::Kind::plane) data.has_axis_planes = true;
    if (!is_plane(surface.kind)) data.has_quadrics = true;
  }
  if (data.is_empty || data.reaches_beyond) return data;
  if (data.is_turned) {
    const double unit = std::ldexp(1.0, scene.frame().exponent);
    data.half_size = (0.5 * unit) * (data.box.upper - data.box.lower);
    data.middle = Point{} + (0.5 * unit) * (data.box.upper + data.box.lower);
  } else {
    data.half_size = 0.5 * (world.upper - world.lower);
    data.middle = world.lower + data.half_size;
  }
  return data;
}

}  // namespace

CellData build_cells(const CellGround& ground, NodeId node, const Formula& whole) {
  CellData data = describe(ground, node, whole);
  CellBuilder builder(ground, ground.scene.leaves().size());
  if (data.reaches_beyond) {
    builder.build_everywhere(whole, data.box);
  } else if (!data.is_empty) {
    data.cost = builder.build_inside(whole, data.box);
  }
  std::move(builder.tree()).move_into(data);
  return data;
}

}  // namespace csgcast::detail
