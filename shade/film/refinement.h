// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shade/film/film.h"
#include "shade/film/tile.h"

namespace csgcast::detail {

/// A place in a picture, from the top left.
struct Pixel {
  int x, y;
};

/// Which pixels of a picture one sample is not enough for. Pixels are chosen by what they look like, never by the tile
/// they are in, and stay chosen: whatever the order, and on any number of threads, the same pixels are chosen in the
/// end.
class Refinement {
 public:
  /// None is chosen.
  Refinement(int width, int height);

  /// Chooses the pixels of a tile that contrast with one of the 8 around. `centers`: the picture with a sample a pixel.
  void choose_contrasts(const Film& centers, const Tile& tile);
  /// Chooses a pixel, if it is in the picture.
  void choose(Pixel pixel);
  /// Whether a pixel of the picture is chosen, taken or not.
  bool is_chosen(Pixel pixel) const;
  /// Overwrites `pixels` with those of the tile, row by row, that were chosen and not taken before. Whether there are
  /// any. Not for the same tile on two threads at a time.
  bool take(const Tile& tile, std::vector<Pixel>& pixels);

 private:
  enum class State : std::uint8_t { sufficient, chosen, taken };

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  std::atomic<State>& state(int x, int y) { return states_[index(x, y)]; }

  int width_;
  int height_;
  std::vector<std::atomic<State>> states_;
};

}  // namespace csgcast::detail
