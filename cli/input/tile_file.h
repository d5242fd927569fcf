// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cli/input/part_label.h"
#include "cli/output/output.h"
#include "shade/film/film.h"
#include "shade/film/pixel_region.h"

namespace csgcast::cli {

/// What the head of a tile's file says: lines of a name and a value, then `end`. After it the numbers of the film
/// follow, 32-bit floats, little-endian, rows from the top.
struct TileHead {
  int index = 0;  ///< of `count` tiles, from 0
  int count = 1;
  int width = 0;  ///< of the whole picture
  int height = 0;
  PixelRegion region;
  FilmContent content = FilmContent::color;
  PartLabel label;

  /// Adds what the whole picture's file shall say of itself.
  void add_note(const std::string& name, const std::string& text) { label.add("note-" + name, text); }
};

/// A picture, and what its file shall say of itself.
struct JoinedPicture {
  Film film;
  std::vector<std::pair<std::string, std::string>> notes;
};

/// Throws Error(usage) unless the path ends in .csgtile.
void check_tile_path(const std::string& path);

void write_tile(const TileHead& head, const Film& film, Output& output);

/// Whether a file begins as a tile does.
bool is_tile(const std::string& path);

/// The whole picture. Throws Error(input_output) for a file that cannot be read, Error(syntax) for one that is no whole
/// tile, Error(usage) if the tiles are not all those of one picture, each once.
JoinedPicture join_tiles(const std::vector<std::string>& paths);

}  // namespace csgcast::cli
