// SPDX-License-Identifier: MIT
#include "shade/film/refinement.h"

#include <algorithm>
#include <array>

#include "shade/film/contrast.h"

namespace csgcast::detail {
namespace {

constexpr int pad_side = tile_side + 2;

// A channel of a tile and of one pixel around it.
using Pad = std::array<std::array<float, pad_side>, pad_side>;

// Beyond the picture its border goes on.
void read_channel(const Film& film, const Tile& tile, int channel, Pad& pad) {
  for (int y = tile.y0 - 1; y <= tile.y1; ++y) {
    const int row = std::clamp(y, 0, film.height() - 1);
    for (int x = tile.x0 - 1; x <= tile.x1; ++x) {
      const float light = film.value(std::clamp(x, 0, film.width() - 1), row, channel);
      pad[static_cast<std::size_t>(y - tile.y0 + 1)][static_cast<std::size_t>(x - tile.x0 + 1)] = perceived(light);
    }
  }
}

// The least and the greatest of each place and its neighbours to the left and right. The first and last place:
// anything.
void spread_sideways(const Pad& pad, Pad& least, Pad& greatest) {
  for (std::size_t y = 0; y < pad_side; ++y) {
    for (std::size_t x = 1; x + 1 < pad_side; ++x) {
      least[y][x] = std::min(std::min(pad[y][x - 1], pad[y][x]), pad[y][x + 1]);
      greatest[y][x] = std::max(std::max(pad[y][x - 1], pad[y][x]), pad[y][x + 1]);
    }
  }
}

}  // namespace

Refinement::Refinement(int width, int height)
    : width_(width), height_(height), states_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

void Refinement::choose_contrasts(const Film& centers, const Tile& tile) {
  constexpr float most = least_contrast;
  Pad pad{};
  Pad least{};
  Pad greatest{};
  for (int channel = 0; channel < 3; ++channel) {
    read_channel(centers, tile, channel, pad);
    spread_sideways(pad, least, greatest);
    for (int j = tile.y0; j < tile.y1; ++j) {
      const auto y = static_cast<std::size_t>(j - tile.y0 + 1);
      for (int i = tile.x0; i < tile.x1; ++i) {
        const auto x = static_cast<std::size_t>(i - tile.x0 + 1);
        const float low = std::min(std::min(least[y - 1][x], least[y][x]), least[y + 1][x]);
        const float high = std::max(std::max(greatest[y - 1][x], greatest[y][x]), greatest[y + 1][x]);
        if (high - pad[y][x] > most || pad[y][x] - low > most) choose({i, j});
      }
    }
  }
}

void Refinement::choose(Pixel pixel) {
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= width_ || pixel.y >= height_) return;
  State expected = State::sufficient;
  state(pixel.x, pixel.y).compare_exchange_strong(expected, State::chosen, std::memory_order_relaxed);
}

bool Refinement::is_chosen(Pixel pixel) const {
  return states_[index(pixel.x, pixel.y)].load(std::memory_order_relaxed) != State::sufficient;
}

bool Refinement::take(const Tile& tile, std::vector<Pixel>& pixels) {
  pixels.clear();
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      if (state(x, y).load(std::memory_order_relaxed) != State::chosen) continue;
      state(x, y).store(State::taken, std::memory_order_relaxed);
      pixels.push_back({x, y});
    }
  }
  return !pixels.empty();
}

}  // namespace csgcast::detail
