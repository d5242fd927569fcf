// SPDX-License-Identifier: MIT
#include "raycast/cells/build/box_tree.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "raycast/cells/build/box_hierarchy.h"
#include "raycast/cells/build/cell_box.h"
#include "raycast/cells/build/conjunctions.h"

namespace csgcast::detail {
namespace {

// With fewer conjunctions cells are as fast.
constexpr std::size_t fewest_conjunctions = 12;
// These are the costs of a line in the units of CellData::cost, measured on unions of balls and of boxes, sparse and
// crowded, and on plates with holes.
constexpr double cost_of_node = 1.5;
constexpr double cost_of_axis_plane = 1;
constexpr double cost_of_plane = 6;
constexpr double cost_of_round = 4;
constexpr double cost_of_quadric = 8;
constexpr double cost_of_event = 1;
// Boxes must be cheaper than cells by at least this factor.
constexpr double least_gain = 1.1;

// Boxes are widened by this much. So neither their own rounding nor that of rays in single precision loses any line.
constexpr double widening = 0x1p-18;

double cost_of_test(LaneSurface::Kind kind) {
  return kind < LaneSurface::Kind::plane ? cost_of_axis_plane
         : is_plane(kind)                ? cost_of_plane
         : is_round(kind)                ? cost_of_round
                                         : cost_of_quadric;
}

// The leaf that the faces on a surface belong to, and the look that they show.
struct Owner {
  LeafId leaf;  // not valid if several leaves own the surface
  LookId look;  // not valid if the look depends on the place
  bool is_known = false;
};

// Finds the owners by surface. Conjunctions that hold nothing count as well: a surface may be a face of one of their
// leaves where its side changes for that leaf alone.
std::vector<Owner> owners_of(const CellGround& ground, const Conjunctions& all) {
  const Scene& scene = ground.scene;
  const auto region_of = [&](const Conjunctions::Side& side) { return scene.leaf(side.leaf).region; };
  const bool one_region = std::all_of(all.sides.begin(), all.sides.end(), [&](const auto& side) {
    return region_of(side) == region_of(all.sides.front());
  });
  std::vector<Owner> owners(scene.surfaces().size());
  for (const Conjunctions::Side& side : all.sides) {
    const LeafId leaf = side.is_one ? side.leaf : LeafId();
    const LookId look = leaf.valid() ? ground.look_of(scene.leaf(leaf), one_region) : LookId();
    Owner& owner = owners[side.surface.index()];
    if (!owner.is_known) owner = {leaf, look, true};
    if (owner.leaf != leaf) owner.leaf = LeafId();
    if (owner.look != look) owner.look = LookId();
  }
  return owners;
}

// Adds the conjunctions in the given order, and gives each of their surfaces its slot.
void add_conjunctions(const CellGround& ground, const Conjunctions& all, std::span<const BoxedItem> order,
                      CellData& data) {
  constexpr std::uint32_t none = 0xffffffffu;
  BoxTree& tree = data.boxes;
  const std::vector<Owner> owners = owners_of(ground, all);
  std::vector<std::uint32_t> first_side(owners.size(), none);  // by surface: the index of the first side that has it
  const auto add_side = [&](const Conjunctions::Side& from) {
    const std::size_t surface = from.surface.index();
    BoxedSide side{0, from.wants_positive, false};
    if (first_side[surface] == none) {
      first_side[surface] = static_cast<std::uint32_t>(tree.sides.size());
      side.slot = static_cast<std::uint32_t>(data.slots.size());
      LaneSurface shape = ground.surfaces[surface];
      // The bound on the error of its form is known in a cell only.
      if (is_revolved(shape.kind)) shape.kind = LaneSurface::Kind::quadric;
      data.slots.emplace_back(shape, from.surface, owners[surface].leaf, owners[surface].look);
      tree.tolerance.allow_for(shape);
    } else {
      BoxedSide& first = tree.sides[first_side[surface]];
      side.slot = first.slot;
      side.is_shared = first.is_shared = true;
    }
    tree.sides.push_back(side);
  };
  for (const BoxedItem& item : order) {
    const Conjunctions::Part& part = all.parts[item.index];
    Conjunction& conjunction = tree.conjunctions.emplace_back();
    conjunction.first = static_cast<std::uint32_t>(tree.sides.size());
    conjunction.count = part.count;
    conjunction.is_subtracted = part.is_subtracted;
    for (const Conjunctions::Side& side : std::span(all.sides).subspan(part.first, part.count)) add_side(side);
  }
}

// Marks children that are balls with the slot of their sphere, so that lines can compute many of them side by side.
void mark_balls(const std::vector<Slot>& slots, BoxTree& tree) {
  if (slots.size() > BoxNode::most_slots) return;
  for (BoxNode& node : tree.nodes) {
    for (std::uint32_t& child : node.child) {
      if ((child & BoxNode::conjunction) == 0) continue;
      const Conjunction& conjunction = tree.conjunctions[child & ~BoxNode::conjunction];
      const BoxedSide& side = tree.sides[conjunction.first];
      const Slot& slot = slots[side.slot];
      const bool outside_is_positive = slot.c[5] > 0;
      if (conjunction.count != 1 || slot.kind != LaneSurface::Kind::sphere || side.is_shared) continue;
      if (side.wants_positive == outside_is_positive) continue;
      child = BoxNode::ball | (conjunction.is_subtracted ? BoxNode::subtracted : 0) | side.slot;
    }
  }
}

std::optional<Brick> brick_of(const std::vector<Slot>& slots, std::span<const BoxedSide> sides) {
  constexpr double far = 1e300;
  if (sides.size() != 6) return std::nullopt;
  Brick brick{};
  brick.lower[3] = -far;
  brick.upper[3] = far;
  unsigned found = 0;  // one bit for each plane
  for (const BoxedSide& side : sides) {
    const Slot& slot = slots[side.slot];
    if (side.is_shared || slot.kind > LaneSurface::Kind::plane_z) return std::nullopt;
    const std::size_t axis = axis_of(slot.kind);
    const bool is_lower = side.wants_positive == (slot.c[1] > 0);
    (is_lower ? brick.lower : brick.upper)[axis] = slot.c[0];
    (is_lower ? brick.lower_slot : brick.upper_slot)[axis] = side.slot;
    found |= 1u << (2 * axis + (is_lower ? 0 : 1));
  }
  return found == 0x3f ? std::optional(brick) : std::nullopt;
}

void mark_bricks(const std::vector<Slot>& slots, BoxTree& tree) {
  for (Conjunction& conjunction : tree.conjunctions) {
    const std::optional<Brick> brick =
        brick_of(slots, std::span(tree.sides).subspan(conjunction.first, conjunction.count));
    if (!brick) continue;
    conjunction.brick = static_cast<std::uint32_t>(tree.bricks.size());
    tree.bricks.push_back(*brick);
  }
}

std::optional<FloatBox> widened(const CellBox& box) {
  FloatBox result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (box.lower[axis] > box.upper[axis]) return std::nullopt;  // the conjunction has nothing in the box
    result.lower[axis] = static_cast<float>(box.lower[axis] - widening);
    result.upper[axis] = static_cast<float>(box.upper[axis] + widening);
  }
  return result;
}

// The expected cost of the tests of a line that meets the box of everything. By Cauchy's formula, the share of these
// lines that meet a convex body in that box is the ratio of the two surface areas.
double cost_of_tests(const CellGround& ground, const Conjunctions& all, const CellBox& everything,
                     std::span<const BoxedItem> items) {
  double cost = 0;
  for (const BoxedItem& item : items) {
    const Conjunctions::Part& part = all.parts[item.index];
    double own = part.count > 1 ? 4 * cost_of_event : 2 * cost_of_event;
    for (const Conjunctions::Side& side : std::span(all.sides).subspan(part.first, part.count))
      own += cost_of_test(ground.surfaces[side.surface.index()].kind);
    cost += own * area(part.box) / area(everything);
  }
  return cost;
}

// The expected cost of the nodes that such a line meets.
double cost_of_nodes(std::span<const BoxNode> nodes, const CellBox& everything) {
  double met = 1;
  for (const BoxNode& node : nodes) {
    for (std::size_t k = 0; k < BoxNode::width; ++k) {
      if (node.child[k] == 0 || (node.child[k] & BoxNode::conjunction) != 0) continue;
      const FloatBox box{{node.side[0][0][k], node.side[0][1][k], node.side[0][2][k]},
                         {node.side[1][0][k], node.side[1][1][k], node.side[1][2][k]}};
      met += box.area() / area(everything);
    }
  }
  return cost_of_node * met;
}

}  // namespace

void add_box_tree(const CellGround& ground, const Formula& whole, CellData& data) {
  if (data.is_empty || data.reaches_beyond || ground.scene.leaves().size() < fewest_conjunctions) return;
  const std::optional<Conjunctions> all = conjunctions_of(ground, whole, inflated(data.box));
  if (!all || all->parts.size() < fewest_conjunctions) return;
  std::vector<BoxedItem> items;
  for (std::size_t i = 0; i < all->parts.size(); ++i) {
    const std::optional<FloatBox> box = widened(all->parts[i].box);
    if (box) items.push_back({*box, static_cast<std::uint32_t>(i)});
  }
  if (items.empty()) return;
  const double most = data.cost / least_gain;
  double cost = cost_of_tests(ground, *all, data.box, items);
  if (cost > most) return;
  std::vector<BoxNode> nodes;
  BoxHierarchy hierarchy(std::move(items), nodes);
  hierarchy.build();
  cost += cost_of_nodes(nodes, data.box);
  if (cost > most) return;
  data.boxes.nodes = std::move(nodes);
  add_conjunctions(ground, *all, hierarchy.order(), data);
  mark_balls(data.slots, data.boxes);
  mark_bricks(data.slots, data.boxes);
}

}  // namespace csgcast::detail
