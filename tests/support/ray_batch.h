// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "raycast/line/ray.h"
#include "raycast/packets/ray_arrays.h"

namespace csgcast::test {

/// The same rays one after the other and coordinate by coordinate: who asks takes what suits.
class RayBatch {
 public:
  RayBatch() = default;
  explicit RayBatch(std::vector<Ray> rays) : rays_(std::move(rays)) {
    for (const Ray& ray : rays_) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        origin_[axis].push_back(ray.origin()[axis]);
        direction_[axis].push_back(ray.direction()[axis]);
      }
    }
  }

  std::size_t size() const { return rays_.size(); }
  std::span<const Ray> list() const { return rays_; }
  RayArrays arrays() const { return arrays(0, size()); }
  /// Rays [first, first + count).
  RayArrays arrays(std::size_t first, std::size_t count) const {
    RayArrays arrays;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      arrays.origin[axis] = {origin(axis, first), count};
      arrays.direction[axis] = {direction(axis, first), count};
    }
    return arrays;
  }
  const double* origin(std::size_t axis, std::size_t first) const { return origin_[axis].data() + first; }
  const double* direction(std::size_t axis, std::size_t first) const { return direction_[axis].data() + first; }

 private:
  std::vector<Ray> rays_;
  std::array<std::vector<double>, 3> origin_;
  std::array<std::vector<double>, 3> direction_;
};

}  // namespace csgcast::test
