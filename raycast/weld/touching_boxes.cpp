// SPDX-License-Identifier: MIT
#include "raycast/weld/touching_boxes.h"

#include <algorithm>
#include <numeric>

namespace csgcast::detail {

TouchingBoxes::TouchingBoxes(std::span<const Box> boxes) : boxes_(boxes), order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  if (boxes.empty()) return;
  nodes_.push_back(node_of(0, static_cast<std::uint32_t>(boxes.size())));
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    const Node node = nodes_[i];
    if (node.count <= few) continue;
    const Vector size = node.box.size();
    const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto place = [&](std::uint32_t k) { return boxes_[k].lower[axis] + boxes_[k].upper[axis]; };
    const auto begin = order_.begin() + node.first;
    const std::uint32_t half = node.count / 2;
    std::nth_element(begin, begin + half, begin + node.count, [&](std::uint32_t k, std::uint32_t l) {
      return place(k) != place(l) ? place(k) < place(l) : k < l;
    });
    nodes_[i].child = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(node_of(node.first, half));
    nodes_.push_back(node_of(node.first + half, node.count - half));
  }
}

TouchingBoxes::Node TouchingBoxes::node_of(std::uint32_t first, std::uint32_t count) const {
  Node node;
  node.first = first;
  node.count = count;
  for (std::uint32_t k = first; k < first + count; ++k) node.box = hull(node.box, boxes_[order_[k]]);
  return node;
}

bool TouchingBoxes::touch(const Box& a, const Box& b, double slack) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a.lower[axis] - slack > b.upper[axis] || b.lower[axis] - slack > a.upper[axis]) return false;
  }
  return true;
}

}  // namespace csgcast::detail
