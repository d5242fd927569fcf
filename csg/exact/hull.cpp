// SPDX-License-Identifier: MIT
#include "csg/exact/hull.h"

#include <algorithm>
#include <numeric>
#include <random>

#include "csg/exact/detail/hull_builder.h"

namespace csgcast {
namespace {

// This is the shuffle of Fisher and Yates. The standard library's may differ between systems.
std::vector<std::uint32_t> shuffled_indices(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937_64 random(0x9e3779b97f4a7c15u);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

}  // namespace

std::vector<HullTriangle> convex_hull(std::span<const Point> points) {
  std::vector<std::uint32_t> order = shuffled_indices(points.size());
  detail::HullBuilder builder(points);
  if (!builder.start(order)) return {};
  for (const std::uint32_t point : order) builder.insert(point);
  return builder.triangles();
}

}  // namespace csgcast
