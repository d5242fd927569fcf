// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "shade/film/film.h"

namespace csgcast::detail {

/// A film in 8 bits: rows from the top, three channels (R, G, B) for colours, normals and ids, else one.
struct EncodedFilm {
  int width = 0;
  int height = 0;
  int channels = 0;
  FilmContent content = FilmContent::color;
  std::vector<std::uint8_t> bytes;
};

/// What FilmContent says of 8 bits. Values are clamped to [0, 1] (not a number: 0), scaled to 255 and rounded to the
/// nearest.
EncodedFilm encode(const Film& film);

/// floor(255 x + 0.5) for x clamped to [0, 1]; 0 for not a number.
std::uint8_t to_byte(double x);

}  // namespace csgcast::detail
