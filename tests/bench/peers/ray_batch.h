// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "raycast/ray.h"
#include "raycast/ray_arrays.h"

namespace csgcast::bench {

/// The same rays one after the other and coordinate by coordinate: each engine takes what suits it.
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
  RayArrays arrays() const {
    RayArrays arrays;
    arrays.count = rays_.size();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      arrays.origin[axis] = origin_[axis].data();
      arrays.direction[axis] = direction_[axis].data();
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

}  // namespace csgcast::bench
