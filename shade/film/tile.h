// SPDX-License-Identifier: MIT
#pragma once

namespace csgcast::detail {

/// The longest side of a tile, in pixels.
constexpr int tile_side = 32;

/// A rectangle of pixels [x0, x1) x [y0, y1), or of samples.
struct Tile {
  int x0, y0, x1, y1;
};

}  // namespace csgcast::detail
