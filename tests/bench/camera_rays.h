// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "raycast/ray.h"
#include "raycast/ray_arrays.h"
#include "shade/camera.h"

namespace csgcast::bench {

/// The rays through the pixels of a square picture, as objects and as arrays. Four by two neighbours come side by side,
/// as packets like them, and blocks of rays are asked about at once: many packets, whose answers stay in the cache.
struct CameraRays {
  static constexpr std::size_t block = 256;

  std::vector<Ray> rays;
  std::array<std::vector<double>, 3> origin;
  std::array<std::vector<double>, 3> direction;

  /// side x side rays. `side`: a multiple of 16, so that all blocks are full.
  CameraRays(const CameraDescription& description, int side) {
    const Camera camera(description, side, side);
    for (int y = 0; y < side; y += 2) {
      for (int x = 0; x < side; x += 4) {
        for (int i = 0; i < 8; ++i) add(camera.ray(x + i % 4 + 0.5, y + i / 4 + 0.5));
      }
    }
  }

  std::size_t size() const { return rays.size(); }

  /// The block of rays from `begin` on.
  RayArrays block_at(std::size_t begin) const {
    RayArrays arrays;
    arrays.count = block;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      arrays.origin[axis] = origin[axis].data() + begin;
      arrays.direction[axis] = direction[axis].data() + begin;
    }
    return arrays;
  }

 private:
  void add(const Ray& ray) {
    rays.push_back(ray);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      origin[axis].push_back(ray.origin()[axis]);
      direction[axis].push_back(ray.direction()[axis]);
    }
  }
};

}  // namespace csgcast::bench
