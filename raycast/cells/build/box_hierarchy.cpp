// SPDX-License-Identifier: MIT
#include "raycast/cells/build/box_hierarchy.h"

namespace csgcast::detail {

BoxHierarchy::Range BoxHierarchy::range_of(std::size_t begin, std::size_t end) const {
  Range range{begin, end, no_box};
  for (std::size_t i = begin; i < end; ++i) range.box.add(items_[i].box);
  return range;
}

std::size_t BoxHierarchy::bin_of(const BoxedItem& item, std::size_t axis, float low, float scale) {
  return std::min(bins - 1, static_cast<std::size_t>((item.middle(axis) - low) * scale));
}

BoxHierarchy::Plane BoxHierarchy::best_plane(const Range& range, std::size_t axis, float low, float scale) const {
  std::array<FloatBox, bins> boxes;
  std::array<std::size_t, bins> counts{};
  boxes.fill(no_box);
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const std::size_t bin = bin_of(items_[i], axis, low, scale);
    boxes[bin].add(items_[i].box);
    ++counts[bin];
  }
  std::array<float, bins> below{};  // by bin: the cost of all bins before it
  FloatBox box = no_box;
  std::size_t count = 0;
  for (std::size_t bin = 0; bin + 1 < bins; ++bin) {
    box.add(boxes[bin]);
    count += counts[bin];
    below[bin + 1] = count == 0 ? HUGE_VALF : box.area() * static_cast<float>(count);
  }
  Plane best;
  box = no_box;
  count = 0;
  for (std::size_t bin = bins - 1; bin > 0; --bin) {
    box.add(boxes[bin]);
    count += counts[bin];
    const float cost = count == 0 ? HUGE_VALF : below[bin] + box.area() * static_cast<float>(count);
    if (cost < best.cost) best = {axis, bin, cost};
  }
  return best;
}

// Sorts the items of a range into two parts, neither of which is empty. Returns the start of the second part.
std::size_t BoxHierarchy::halve(const Range& range) {
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
  if (best.bin == 0) return range.begin + range.size() / 2;  // all items lie in one place
  const auto first = items_.begin() + static_cast<std::ptrdiff_t>(range.begin);
  const auto last = items_.begin() + static_cast<std::ptrdiff_t>(range.end);
  const auto second = std::stable_partition(first, last, [&](const BoxedItem& item) {
    return bin_of(item, best.axis, low[best.axis], scale[best.axis]) < best.bin;
  });
  return static_cast<std::size_t>(second - items_.begin());
}

void BoxHierarchy::make_branches() {
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

float BoxHierarchy::cost_of_halves(const Branch& branch, std::size_t places, std::size_t for_first) const {
  return branches_[branch.halves].costs[for_first - 1] + branches_[branch.halves + 1].costs[places - for_first - 1];
}

// A branch gets a number of places. This finds how many of them its first half should get.
std::size_t BoxHierarchy::best_share(const Branch& branch, std::size_t places) const {
  std::size_t best = 1;
  for (std::size_t share = 2; share < places; ++share) {
    if (cost_of_halves(branch, places, share) < cost_of_halves(branch, places, best)) best = share;
  }
  return best;
}

// Sets the costs of a branch from the costs of its halves.
void BoxHierarchy::set_costs(Branch& branch) const {
  if (branch.halves == 0) return;
  const auto cost_in = [&](std::size_t places) { return cost_of_halves(branch, places, best_share(branch, places)); };
  branch.costs[0] = branch.range.box.area() + cost_in(BoxNode::width);
  for (std::size_t places = 2; places <= BoxNode::width; ++places)
    branch.costs[places - 1] = std::min(branch.costs[places - 2], cost_in(places));
}

// Chooses which parts of a branch fill the given number of places of a node. Each recursive call gets fewer places, so
// the recursion is not deep.
void BoxHierarchy::choose(std::uint32_t index, std::size_t places, Chosen& chosen, std::size_t& count) const {
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

void BoxHierarchy::make_nodes() {
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
      const FloatBox& box = is_empty ? no_box : part->range.box;
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

void BoxHierarchy::build() {
  make_branches();
  // The halves of a branch come after it, so their costs are known first when going backwards.
  for (std::size_t i = branches_.size(); i-- > 0;) set_costs(branches_[i]);
  make_nodes();
}

}  // namespace csgcast::detail
