// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "csg/base/precondition.h"
#include "csg/solid/look.h"

namespace csgcast {

/// What the numbers of a film mean, which decides how an image file holds them.
enum class FilmContent : std::uint8_t {
  color,        ///< linear light; sRGB in 8 and 16 bits
  color_alpha,  ///< linear light times alpha, and alpha: the share of the pixel that shows the solid
  position,     ///< places in the scene, not a number where there is nothing
  normal,       ///< 0.5 + 0.5 n for unit normals n, 0 where there is nothing; as it is in 8 bits
  depth,   ///< lengths, infinite where there is nothing; in 8 bits the nearest is white, the farthest dark, nothing
           ///< black
  length,  ///< lengths, 0 where there is nothing; in 8 bits the longest finite one is white, and so are infinite ones
  id,      ///< whole numbers, -1 where there is nothing; in 8 bits each a colour unlike that of the numbers next to it,
           ///< nothing black
};

constexpr int channels(FilmContent content) {
  switch (content) {
    case FilmContent::color:
    case FilmContent::normal:
    case FilmContent::position:
      return 3;
    case FilmContent::color_alpha:
      return 4;
    case FilmContent::depth:
    case FilmContent::length:
    case FilmContent::id:
      break;
  }
  return 1;
}

/// A picture in memory: rows from the top, pixels from the left, `channels(content)` floats a pixel.
class Film {
 public:
  /// All zero. Precondition: positive sizes.
  Film(int width, int height, FilmContent content)
      : width_(width),
        height_(height),
        content_(content),
        channels_(static_cast<std::size_t>(channels(content))),
        values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * channels_) {
    CSGCAST_PRECONDITION(width > 0 && height > 0);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  FilmContent content() const { return content_; }
  const std::vector<float>& values() const { return values_; }

  float& value(int x, int y, int channel = 0) { return values_[index(x, y) + channel]; }
  float value(int x, int y, int channel = 0) const { return values_[index(x, y) + channel]; }
  Rgb rgb(int x, int y) const { return {value(x, y, 0), value(x, y, 1), value(x, y, 2)}; }
  void set(int x, int y, Rgb color) { set(x, y, std::span<const Rgb>(&color, 1)); }
  /// Pixels of one row, from x on. Precondition: three channels, and they are within the row.
  void set(int x, int y, std::span<const Rgb> colors) {
    CSGCAST_PRECONDITION(channels_ == 3 && x >= 0 && y >= 0 && y < height_ &&
                         static_cast<std::size_t>(x) + colors.size() <= static_cast<std::size_t>(width_));
    auto* to = &values_[index(x, y)];
    for (const Rgb& color : colors) {
      to[0] = static_cast<float>(color.r);
      to[1] = static_cast<float>(color.g);
      to[2] = static_cast<float>(color.b);
      to += 3;
    }
  }

 private:
  std::size_t index(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) * channels_;
  }

  int width_;
  int height_;
  FilmContent content_;
  std::size_t channels_;
  std::vector<float> values_;
};

}  // namespace csgcast
