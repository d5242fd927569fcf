// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "shade/film/film.h"

namespace csgcast::detail {

/// A film in 8 or 16 bits: rows from the top. Colours, normals, places and ids have three channels (R, G, B), with
/// alpha four, else one. Alpha is not multiplied into the colours.
struct EncodedFilm {
  int width = 0;
  int height = 0;
  int channels = 0;
  FilmContent content = FilmContent::color;
  std::vector<std::uint8_t> bytes{};   ///< with 8 bits
  std::vector<std::uint16_t> words{};  ///< with 16 bits
};

/// What FilmContent says of levels. Values are clamped to [0, 1] (not a number: 0), scaled to 255 or 65535 and rounded
/// to the nearest. Precondition: bits are 8 or 16.
EncodedFilm encode(const Film& film, int bits = 8);

/// floor(255 x + 0.5) for x clamped to [0, 1]; 0 for not a number.
std::uint8_t to_byte(double x);
/// The same of 65535.
std::uint16_t to_word(double x);

}  // namespace csgcast::detail
