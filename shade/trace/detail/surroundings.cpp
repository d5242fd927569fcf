// SPDX-License-Identifier: MIT
#include "shade/trace/detail/surroundings.h"

#include <array>
#include <map>
#include <utility>

namespace csgcast::detail {
namespace {

std::array<Pixel, 4> neighbours(Pixel p) { return {{{p.x, p.y - 1}, {p.x, p.y + 1}, {p.x - 1, p.y}, {p.x + 1, p.y}}}; }

using Key = std::pair<int, int>;
Key key(Pixel pixel) { return {pixel.y, pixel.x}; }

}  // namespace

bool Surroundings::is_in_picture(Pixel pixel) const {
  const int x = pixel.x + job_.origin.x;
  const int y = pixel.y + job_.origin.y;
  return x >= 0 && y >= 0 && x < job_.width && y < job_.height;
}

bool Surroundings::is_in_tile(Pixel pixel) const {
  return pixel.x >= tile_.x0 && pixel.y >= tile_.y0 && pixel.x < tile_.x1 && pixel.y < tile_.y1;
}

bool Surroundings::is_in_film(Pixel pixel) const {
  return pixel.x >= tile_.x0 - 1 && pixel.y >= tile_.y0 - 1 && pixel.x <= tile_.x1 && pixel.y <= tile_.y1;
}

std::vector<PixelSide> Surroundings::open_sides(const Refinement& refinement) const {
  std::vector<PixelSide> sides;
  const auto look = [&](Pixel inside, Pixel beyond) {
    if (is_in_picture(beyond) && !refinement.is_chosen(inside)) sides.push_back({beyond, inside});
  };
  for (int x = tile_.x0; x < tile_.x1; ++x) {
    look({x, tile_.y0}, {x, tile_.y0 - 1});
    look({x, tile_.y1 - 1}, {x, tile_.y1});
  }
  for (int y = tile_.y0; y < tile_.y1; ++y) {
    look({tile_.x0, y}, {tile_.x0 - 1, y});
    look({tile_.x1 - 1, y}, {tile_.x1, y});
  }
  return sides;
}

bool Surroundings::choose(const std::vector<PixelSide>& sides, TileRenderer& renderer, Refinement& refinement) const {
  // Pixels beyond that reach a side, maybe by way of others: for each, the next ones towards the tile.
  std::map<Key, std::vector<Pixel>> next;
  std::vector<Pixel> to_look_at;
  std::vector<Pixel> chosen;
  const auto reaches = [&](const PixelSide& side) {
    const auto [at, is_new] = next.try_emplace(key(side.pixel));
    at->second.push_back(side.neighbour);
    if (is_new) to_look_at.push_back(side.pixel);
  };
  for (const PixelSide& side : sides) reaches(side);
  std::vector<PixelSide> around;
  std::vector<bool> varies;
  while (!to_look_at.empty()) {
    const Pixel pixel = to_look_at.back();
    to_look_at.pop_back();
    if ((is_in_film(pixel) && refinement.is_chosen(pixel)) || renderer.contrasts(pixel)) {
      chosen.push_back(pixel);
      continue;
    }
    around.clear();
    for (const Pixel other : neighbours(pixel)) {
      if (is_in_picture(other) && !is_in_tile(other)) around.push_back({other, pixel});
    }
    renderer.look_along_sides(around, varies);
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (varies[i]) reaches(around[i]);
    }
  }
  bool any = false;
  while (!chosen.empty()) {
    const Pixel pixel = chosen.back();
    chosen.pop_back();
    if (is_in_tile(pixel)) {
      any = any || !refinement.is_chosen(pixel);
      refinement.choose(pixel);
      continue;
    }
    const auto at = next.find(key(pixel));
    if (at == next.end()) continue;  // done
    chosen.insert(chosen.end(), at->second.begin(), at->second.end());
    next.erase(at);
  }
  return any;
}

}  // namespace csgcast::detail
