// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "raycast/line/ray.h"
#include "raycast/packets/ray_arrays.h"
#include "shade/film/camera.h"
#include "tests/support/ray_batch.h"

namespace csgcast::bench {

/// The rays through the pixels of a square picture, as objects and as arrays. Four by two neighbours come side by side,
/// as packets like them, and blocks of rays are asked about at once: many packets, whose answers stay in the cache.
class CameraRays {
 public:
  static constexpr std::size_t block = 256;

  /// side x side rays. `side`: a multiple of 16, so that all blocks are full.
  CameraRays(const CameraDescription& description, int side)
      : batch_(through_pixels({description, side, side}, side)) {}

  std::size_t size() const { return batch_.size(); }
  std::span<const Ray> list() const { return batch_.list(); }
  /// The block of rays from `begin` on.
  RayArrays block_at(std::size_t begin) const { return batch_.arrays(begin, block); }

 private:
  static std::vector<Ray> through_pixels(const Camera& camera, int side) {
    std::vector<Ray> rays;
    for (int y = 0; y < side; y += 2) {
      for (int x = 0; x < side; x += 4) {
        for (int i = 0; i < 8; ++i) rays.push_back(camera.ray(x + i % 4 + 0.5, y + i / 4 + 0.5));
      }
    }
    return rays;
  }

  test::RayBatch batch_;
};

}  // namespace csgcast::bench
