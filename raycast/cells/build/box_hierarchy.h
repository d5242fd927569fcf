// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "raycast/cells/build/cell_data.h"

namespace csgcast::detail {

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

/// An empty place: its lower sides are above every coordinate, and its upper sides below.
inline constexpr FloatBox no_box{{1000, 1000, 1000}, {-1000, -1000, -1000}};

/// A conjunction in the hierarchy, during construction.
struct BoxedItem {
  FloatBox box;
  std::uint32_t index = 0;

  /// Twice the middle of the box along an axis.
  float middle(std::size_t axis) const { return box.lower[axis] + box.upper[axis]; }
};

/// Makes a hierarchy of boxes. It is first a binary one by the surface area heuristic. Parts of it are then joined to
/// nodes of eight children, so that lines meet as few nodes as possible.
class BoxHierarchy {
 public:
  /// The nodes are added to `nodes`, which must be empty and outlive this. Precondition: there are items.
  BoxHierarchy(std::vector<BoxedItem> items, std::vector<BoxNode>& nodes) : items_(std::move(items)), nodes_(nodes) {}

  void build();
  /// The items in the order in which the nodes' children number them. Items that lie next to each other in space are
  /// then near in memory.
  const std::vector<BoxedItem>& order() const { return items_; }

 private:
  struct Range {
    std::size_t begin = 0, end = 0;
    FloatBox box = no_box;

    std::size_t size() const { return end - begin; }
  };
  // A node of the binary hierarchy. Its two halves lie side by side, behind it.
  struct Branch {
    Range range;
    std::uint32_t halves = 0;  // the index of the first half; 0 if the branch has only one item
    // costs[i] is the least area of all nodes below, if the content of this branch gets at most i + 1 places of a node.
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
  static std::size_t bin_of(const BoxedItem& item, std::size_t axis, float low, float scale);
  Plane best_plane(const Range& range, std::size_t axis, float low, float scale) const;
  void make_branches();
  float cost_of_halves(const Branch& branch, std::size_t places, std::size_t for_first) const;
  std::size_t best_share(const Branch& branch, std::size_t places) const;
  void set_costs(Branch& branch) const;
  void choose(std::uint32_t branch, std::size_t places, Chosen& chosen, std::size_t& count) const;
  void make_nodes();

  std::vector<BoxedItem> items_;
  std::vector<Branch> branches_;
  std::vector<BoxNode>& nodes_;
};

}  // namespace csgcast::detail
