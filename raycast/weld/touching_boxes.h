// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "csg/base/box.h"

namespace csgcast::detail {

/// Finds which of many finite boxes touch, by a hierarchy of boxes over them.
class TouchingBoxes {
 public:
  explicit TouchingBoxes(std::span<const Box> boxes);

  /// Calls take(i, j), i < j, for each two boxes that are at most `slack` apart on every axis. The order depends on the
  /// boxes alone. If take returns false, the search ends and returns false, too.
  template <class Take>
  bool search(double slack, Take&& take) const {
    if (nodes_.empty()) return true;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{0, 0}};
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      const Node& first = nodes_[a];
      const Node& second = nodes_[b];
      if (!touch(first.box, second.box, slack)) continue;
      if (first.is_end() && second.is_end()) {
        if (!compare(first, second, slack, take)) return false;
      } else if (a == b) {
        open.insert(open.end(), {{first.child, first.child}, {first.child + 1, first.child + 1}});
        open.emplace_back(first.child, first.child + 1);
      } else if (second.is_end() || (!first.is_end() && first.count >= second.count)) {
        open.insert(open.end(), {{first.child, b}, {first.child + 1, b}});
      } else {
        open.insert(open.end(), {{a, second.child}, {a, second.child + 1}});
      }
    }
    return true;
  }

 private:
  static constexpr std::uint32_t few = 4;  // boxes of a node that is not parted
  struct Node {
    Box box;
    std::uint32_t first = 0;  // of its boxes, in order_
    std::uint32_t count = 0;
    std::uint32_t child = 0;  // the first of two, which stand together; 0 if there are none

    bool is_end() const { return child == 0; }
  };

  static bool touch(const Box& a, const Box& b, double slack);

  template <class Take>
  bool compare(const Node& a, const Node& b, double slack, Take& take) const {
    for (std::uint32_t k = a.first; k < a.first + a.count; ++k) {
      for (std::uint32_t l = &a == &b ? k + 1 : b.first; l < b.first + b.count; ++l) {
        const std::uint32_t i = order_[k], j = order_[l];
        if (!touch(boxes_[i], boxes_[j], slack)) continue;
        if (!(i < j ? take(i, j) : take(j, i))) return false;
      }
    }
    return true;
  }

  Node node_of(std::uint32_t first, std::uint32_t count) const;

  std::span<const Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace csgcast::detail
