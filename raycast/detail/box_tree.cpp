// SPDX-License-Identifier: MIT
#include "raycast/detail/box_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "raycast/detail/conjunctions.h"

namespace csgcast::detail {
namespace {

// With fewer conjunctions cells are as good.
constexpr std::size_t fewest_conjunctions = 12;
// What a line costs, in the units of CellData::cost: measured on unions of balls and of boxes, sparse and crowded, and
// on plates with holes.
constexpr double cost_of_node = 1.5;
constexpr double cost_of_axis_plane = 1;
constexpr double cost_of_plane = 6;
constexpr double cost_of_round = 4;
constexpr double cost_of_quadric = 8;
constexpr double cost_of_event = 1;
// Boxes must be cheaper by so much.
constexpr double least_gain = 1.1;

// Boxes are so much wider that neither their rounding nor that of rays in single precision loses any line.
constexpr double widening = 0x1p-18;

using Float3 = std::array<float, 3>;

struct FloatBox {
  Float3 lower, upper;

  void add(const FloatBox& other) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis] = std::min(lower[axis], other.lower[axis]);
      upper[axis] = std::max(upper[axis], other.upper[axis]);
    }
  }
  float area() const {
    const float x = upper[0] - lower[0], y = upper[1] - lower[1], z = upper[2] - lower[2];
    return x * y + y * z + z * x;
  }
};

// Beyond every coordinate, with a lower side above the upper one.
constexpr FloatBox nothing{{1000, 1000, 1000}, {-1000, -1000, -1000}};

double cost_of_test(LaneSurface::Kind kind) {
  return kind < LaneSurface::Kind::plane ? cost_of_axis_plane
         : is_plane(kind)                ? cost_of_plane
         : is_round(kind)                ? cost_of_round
                                         : cost_of_quadric;
}

// A conjunction while the hierarchy is made.
struct Item {
  FloatBox box;
  std::uint32_t index = 0;

  float middle(std::size_t axis) const { return box.lower[axis] + box.upper[axis]; }
};

// Whose faces a surface makes.
struct Owner {
  LeafId leaf;  // not valid if there are more
  LookId look;  // not valid if it depends
  bool is_known = false;
};

// By surface. Conjunctions that hold nothing count: flipped in one of their leaves alone, the surface may make a face.
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
void add_conjunctions(const CellGround& ground, const Conjunctions& all, std::span<const Item> order, CellData& data) {
  constexpr std::uint32_t none = 0xffffffffu;
  BoxTree& tree = data.boxes;
  const std::vector<Owner> owners = owners_of(ground, all);
  std::vector<std::uint32_t> first_side(owners.size(), none);  // that has the surface
  const auto add_side = [&](const Conjunctions::Side& from) {
    const std::size_t surface = from.surface.index();
    BoxedSide side{0, from.wants_positive, false};
    if (first_side[surface] == none) {
      first_side[surface] = static_cast<std::uint32_t>(tree.sides.size());
      side.slot = static_cast<std::uint32_t>(data.slots.size());
      const LaneSurface& shape = ground.surfaces[surface];
      data.slots.emplace_back(shape, from.surface, owners[surface].leaf, owners[surface].look);
      if (is_round(shape.kind)) tree.slack = round_slack;
      if (may_have_twins(shape)) tree.may_have_twins = true;
    } else {
      BoxedSide& first = tree.sides[first_side[surface]];
      side.slot = first.slot;
      side.is_shared = first.is_shared = true;
    }
    tree.sides.push_back(side);
  };
  for (const Item& item : order) {
    const Conjunctions::Part& part = all.parts[item.index];
    Conjunction& conjunction = tree.conjunctions.emplace_back();
    conjunction.first = static_cast<std::uint32_t>(tree.sides.size());
    conjunction.count = part.count;
    conjunction.is_subtracted = part.is_subtracted;
    for (const Conjunctions::Side& side : std::span(all.sides).subspan(part.first, part.count)) add_side(side);
  }
}

// Balls are told by their slots: lines find many of them side by side.
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
  unsigned found = 0;  // a bit for each plane
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

// The hierarchy: halved by the surface area heuristic, and of the halves those are joined to nodes of eight that let
// lines meet the fewest nodes.
class Hierarchy {
 public:
  Hierarchy(std::vector<Item> items, std::vector<BoxNode>& nodes) : items_(std::move(items)), nodes_(nodes) {}

  void build();
  // What the children count: in this order conjunctions that lie next to each other are near in memory.
  const std::vector<Item>& order() const { return items_; }

 private:
  struct Range {
    std::size_t begin = 0, end = 0;
    FloatBox box = nothing;

    std::size_t size() const { return end - begin; }
  };
  // Of the binary tree: its two halves lie side by side, behind it.
  struct Branch {
    Range range;
    std::uint32_t halves = 0;  // none: one item
    // [i]: the area of all nodes below, if at most i + 1 of a node's places hold what is here.
    std::array<float, BoxNode::width> costs{};
  };
  using Chosen = std::array<std::uint32_t, BoxNode::width>;
  static constexpr std::size_t bins = 16;
  struct Plane {
    std::size_t axis = 0;
    std::size_t bin = 0;
    float cost = HUGE_VALF;
  };

  Range range_of(std::size_t begin, std::size_t end) const;
  std::size_t halve(const Range& range);
  static std::size_t bin_of(const Item& item, std::size_t axis, float low, float scale);
  Plane best_plane(const Range& range, std::size_t axis, float low, float scale) const;
  void make_branches();
  float cost_of_halves(const Branch& branch, std::size_t places, std::size_t for_first) const;
  std::size_t best_share(const Branch& branch, std::size_t places) const;
  void set_costs(Branch& branch) const;
  void choose(std::uint32_t branch, std::size_t places, Chosen& chosen, std::size_t& count) const;
  void make_nodes();

  std::vector<Item> items_;
  std::vector<Branch> branches_;
  std::vector<BoxNode>& nodes_;
};

Hierarchy::Range Hierarchy::range_of(std::size_t begin, std::size_t end) const {
  Range range{begin, end, nothing};
  for (std::size_t i = begin; i < end; ++i) range.box.add(items_[i].box);
  return range;
}

std::size_t Hierarchy::bin_of(const Item& item, std::size_t axis, float low, float scale) {
  return std::min(bins - 1, static_cast<std::size_t>((item.middle(axis) - low) * scale));
}

Hierarchy::Plane Hierarchy::best_plane(const Range& range, std::size_t axis, float low, float scale) const {
  std::array<FloatBox, bins> boxes;
  std::array<std::size_t, bins> counts{};
  boxes.fill(nothing);
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const std::size_t bin = bin_of(items_[i], axis, low, scale);
    boxes[bin].add(items_[i].box);
    ++counts[bin];
  }
  std::array<float, bins> below{};  // the cost of all bins before one
  FloatBox box = nothing;
  std::size_t count = 0;
  for (std::size_t bin = 0; bin + 1 < bins; ++bin) {
    box.add(boxes[bin]);
    count += counts[bin];
    below[bin + 1] = count == 0 ? HUGE_VALF : box.area() * static_cast<float>(count);
  }
  Plane best;
  box = nothing;
  count = 0;
  for (std::size_t bin = bins - 1; bin > 0; --bin) {
    box.add(boxes[bin]);
    count += counts[bin];
    const float cost = count == 0 ? HUGE_VALF : below[bin] + box.area() * static_cast<float>(count);
    if (cost < best.cost) best = {axis, bin, cost};
  }
  return best;
}

// Sorts the items of a range into two parts, neither empty; returns where the second begins.
std::size_t Hierarchy::halve(const Range& range) {
  Float3 low{HUGE_VALF, HUGE_VALF, HUGE_VALF}, scale{};
  Float3 high{-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};
  for (std::size_t i = range.begin; i < range.end; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], items_[i].middle(axis));
      high[axis] = std::max(high[axis], items_[i].middle(axis));
    }
  }
  Plane best;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float length = high[axis] - low[axis];
    if (!(length > 1e-9f)) continue;
    scale[axis] = static_cast<float>(bins) / length;
    const Plane plane = best_plane(range, axis, low[axis], scale[axis]);
    if (plane.cost < best.cost) best = plane;
  }
  if (best.bin == 0) return range.begin + range.size() / 2;  // all in one place
  const auto first = items_.begin() + static_cast<std::ptrdiff_t>(range.begin);
  const auto last = items_.begin() + static_cast<std::ptrdiff_t>(range.end);
  const auto second = std::stable_partition(first, last, [&](const Item& item) {
    return bin_of(item, best.axis, low[best.axis], scale[best.axis]) < best.bin;
  });
  return static_cast<std::size_t>(second - items_.begin());
}

void Hierarchy::make_branches() {
  branches_.reserve(2 * items_.size());
  branches_.push_back({range_of(0, items_.size()), 0, {}});
  for (std::size_t i = 0; i < branches_.size(); ++i) {
    const Range range = branches_[i].range;
    if (range.size() < 2) continue;
    branches_[i].halves = static_cast<std::uint32_t>(branches_.size());
    const std::size_t middle = halve(range);
    branches_.push_back({range_of(range.begin, middle), 0, {}});
    branches_.push_back({range_of(middle, range.end), 0, {}});
  }
}

float Hierarchy::cost_of_halves(const Branch& branch, std::size_t places, std::size_t for_first) const {
  return branches_[branch.halves].costs[for_first - 1] + branches_[branch.halves + 1].costs[places - for_first - 1];
}

// How many of some places the first half should get.
std::size_t Hierarchy::best_share(const Branch& branch, std::size_t places) const {
  std::size_t best = 1;
  for (std::size_t share = 2; share < places; ++share) {
    if (cost_of_halves(branch, places, share) < cost_of_halves(branch, places, best)) best = share;
  }
  return best;
}

// Those of its halves are known.
void Hierarchy::set_costs(Branch& branch) const {
  if (branch.halves == 0) return;
  const auto cost_in = [&](std::size_t places) { return cost_of_halves(branch, places, best_share(branch, places)); };
  branch.costs[0] = branch.range.box.area() + cost_in(BoxNode::width);
  for (std::size_t places = 2; places <= BoxNode::width; ++places)
    branch.costs[places - 1] = std::min(branch.costs[places - 2], cost_in(places));
}

// What the places of a node should hold of a branch, at most so many. Not deep: each time there are fewer places.
void Hierarchy::choose(std::uint32_t index, std::size_t places, Chosen& chosen, std::size_t& count) const {
  const Branch& branch = branches_[index];
  while (places > 1 && branch.costs[places - 1] == branch.costs[places - 2]) --places;
  if (places == 1) {
    chosen[count++] = index;
    return;
  }
  const std::size_t share = best_share(branch, places);
  choose(branch.halves, share, chosen, count);
  choose(branch.halves + 1, places - share, chosen, count);
}

void Hierarchy::make_nodes() {
  struct Work {
    std::uint32_t branch;
    std::size_t node;
  };
  std::vector<Work> work{{0, 0}};
  nodes_.emplace_back();
  while (!work.empty()) {
    const Work at = work.back();
    work.pop_back();
    Chosen chosen{};
    std::size_t count = 0;
    if (const std::uint32_t halves = branches_[at.branch].halves; halves != 0) {
      const std::size_t share = best_share(branches_[at.branch], BoxNode::width);
      choose(halves, share, chosen, count);
      choose(halves + 1, BoxNode::width - share, chosen, count);
    } else {
      chosen[count++] = at.branch;
    }
    for (std::size_t k = 0; k < BoxNode::width; ++k) {
      const bool is_empty = k >= count;
      const Branch* const part = is_empty ? nullptr : &branches_[chosen[k]];
      const FloatBox& box = is_empty ? nothing : part->range.box;
      std::uint32_t child = 0;
      if (!is_empty && part->halves == 0) {
        child = BoxNode::conjunction | static_cast<std::uint32_t>(part->range.begin);
      } else if (!is_empty) {
        child = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        work.push_back({chosen[k], child});
      }
      BoxNode& node = nodes_[at.node];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        node.side[0][axis][k] = box.lower[axis];
        node.side[1][axis][k] = box.upper[axis];
      }
      node.child[k] = child;
    }
  }
}

void Hierarchy::build() {
  make_branches();
  // Halves come behind what they are halves of.
  for (std::size_t i = branches_.size(); i-- > 0;) set_costs(branches_[i]);
  make_nodes();
}

std::optional<FloatBox> widened(const CellBox& box) {
  FloatBox result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (box.lower[axis] > box.upper[axis]) return std::nullopt;  // nothing of it can matter
    result.lower[axis] = static_cast<float>(box.lower[axis] - widening);
    result.upper[axis] = static_cast<float>(box.upper[axis] + widening);
  }
  return result;
}

// Cauchy: of the lines through a convex body those that meet one in it are as many as their areas say.
double cost_of_tests(const CellGround& ground, const Conjunctions& all, const CellBox& everything,
                     std::span<const Item> items) {
  double cost = 0;
  for (const Item& item : items) {
    const Conjunctions::Part& part = all.parts[item.index];
    double own = part.count > 1 ? 4 * cost_of_event : 2 * cost_of_event;
    for (const Conjunctions::Side& side : std::span(all.sides).subspan(part.first, part.count))
      own += cost_of_test(ground.surfaces[side.surface.index()].kind);
    cost += own * area(part.box) / area(everything);
  }
  return cost;
}

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
  std::vector<Item> items;
  for (std::size_t i = 0; i < all->parts.size(); ++i) {
    const std::optional<FloatBox> box = widened(all->parts[i].box);
    if (box) items.push_back({*box, static_cast<std::uint32_t>(i)});
  }
  if (items.empty()) return;
  const double most = data.cost / least_gain;
  double cost = cost_of_tests(ground, *all, data.box, items);
  if (cost > most) return;
  std::vector<BoxNode> nodes;
  Hierarchy hierarchy(std::move(items), nodes);
  hierarchy.build();
  cost += cost_of_nodes(nodes, data.box);
  if (cost > most) return;
  data.boxes.nodes = std::move(nodes);
  add_conjunctions(ground, *all, hierarchy.order(), data);
  mark_balls(data.slots, data.boxes);
  mark_bricks(data.slots, data.boxes);
}

}  // namespace csgcast::detail
