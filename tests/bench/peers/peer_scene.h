// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "raycast/line/ray.h"
#include "raycast/scene/scene.h"
#include "tests/bench/peers/part_tree.h"

namespace csgcast::bench {

/// One solid, for csgcast and for the others, and the rays of its camera.
struct PeerScene {
  std::string name;
  Scene compiled;
  PartTree tree;
  std::vector<Ray> rays;
  double size = 0;  ///< the diagonal of its bounds
};

/// Reads a scene text. Rays: side x side, tile by tile (see tile_side). Throws if the camera is missing, or not outside
/// the solid's bounds.
PeerScene read_peer_scene(const std::string& file, int side);

/// Rays come in square tiles of this side, row by row of tiles, and within a tile in Z order: each 8 rays in a row are
/// 4 x 2 neighbours, each 16 are 4 x 4. Packets are as coherent as they can be, and an engine that takes rays one by
/// one finds what it needs still in the cache.
constexpr int tile_side = 8;
constexpr std::size_t tile_rays = std::size_t{tile_side} * tile_side;

/// Every `stride`-th tile's rays.
std::vector<Ray> every_tile(const std::vector<Ray>& rays, std::size_t stride);

}  // namespace csgcast::bench
