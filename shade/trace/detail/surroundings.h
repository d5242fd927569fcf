// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "shade/film/refinement.h"
#include "shade/film/tile.h"
#include "shade/trace/detail/tiles.h"

namespace csgcast::detail {

/// What lies around a tile of a film reaches into it, where the tile is made alone: pixels of the tile that adaptive
/// samples choose from beyond it.
///
/// Pixels beyond are in the film for one pixel around the tile, if they are in the picture. Whether they are chosen is
/// found backwards, from the tile's border outwards, and only as far as something varies along the sides of pixels.
class Surroundings {
 public:
  /// Of a picture of job.width x job.height; places are those of the film.
  Surroundings(const Job& job, const Tile& tile) : job_(job), tile_(tile) {}

  /// The sides of pixels beyond that reach into pixels of the tile that are not chosen.
  std::vector<PixelSide> open_sides(const Refinement& refinement) const;

  /// Chooses what pixels beyond reach, where `sides` are those of open_sides() along which something varies. Whether
  /// there was any.
  bool choose(const std::vector<PixelSide>& sides, TileRenderer& renderer, Refinement& refinement) const;

 private:
  bool is_in_picture(Pixel pixel) const;
  bool is_in_tile(Pixel pixel) const;
  bool is_in_film(Pixel pixel) const;

  const Job& job_;
  Tile tile_;
};

}  // namespace csgcast::detail
