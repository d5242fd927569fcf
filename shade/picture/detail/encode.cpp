// SPDX-License-Identifier: MIT
#include "shade/picture/detail/encode.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "csg/base/precondition.h"
#include "csg/solid/look.h"
#include "shade/picture/detail/srgb_bytes.h"

namespace csgcast::detail {
namespace {

// The farthest is this light, so that it differs from nothing at all.
constexpr double farthest_shade = 0.12;

// Low and high end of the finite values; both 0 if there is none.
std::array<double, 2> range_of(const Film& film) {
  bool any = false;
  std::array<double, 2> range{};
  for (const float value : film.values()) {
    if (!std::isfinite(value)) continue;
    const double v = value;
    range = any ? std::array{std::min(range[0], v), std::max(range[1], v)} : std::array{v, v};
    any = true;
  }
  return range;
}

double shade_of_depth(double depth, std::array<double, 2> range) {
  if (!std::isfinite(depth)) return 0;
  const double extent = range[1] - range[0];
  return extent > 0 ? 1 - (1 - farthest_shade) * (depth - range[0]) / extent : 1;
}

double shade_of_length(double length, double longest) {
  if (length <= 0) return 0;
  return std::isfinite(length) ? length / longest : 1;
}

// One after another a golden ratio of the circle of hues apart, in three lightnesses.
std::array<double, 3> color_of_id(double id) {
  if (id < 0) return {};
  constexpr double golden = 0.6180339887498949;
  constexpr std::array<double, 3> lightness{1.0, 0.75, 0.5};
  const double hue = std::fmod(id * golden, 1.0);
  const double value = lightness[static_cast<std::size_t>(std::fmod(id, 3.0))];
  const auto channel = [&](double third) {
    const double wave = std::fabs(std::fmod(hue + third, 1.0) * 6 - 3) - 1;
    return value * (0.25 + 0.75 * std::clamp(wave, 0.0, 1.0));
  };
  return {channel(0), channel(2.0 / 3), channel(1.0 / 3)};
}

// Levels of a type, and what makes one of linear light.
struct Bytes {
  using Level = std::uint8_t;
  SrgbBytes srgb{};
  static Level level(double x) { return to_byte(x); }
};
struct Words {
  using Level = std::uint16_t;
  static Level level(double x) { return to_word(x); }
  static Level srgb(float linear) { return to_word(srgb_from_linear(std::clamp(linear, 0.0F, 1.0F))); }
};

// Neighbours mostly have the same id, and the same colour then.
template <class Levels>
void color_ids(const std::vector<float>& ids, std::vector<typename Levels::Level>& levels) {
  std::array<typename Levels::Level, 3> color{};
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (i == 0 || ids[i] != ids[i - 1]) {
      const std::array<double, 3> channels = color_of_id(ids[i]);
      std::transform(channels.begin(), channels.end(), color.begin(), Levels::level);
    }
    std::copy(color.begin(), color.end(), levels.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
}

// Colours without the alpha that is multiplied into them.
template <class Levels>
void divide_by_alpha(const Levels& of, const std::vector<float>& values, std::vector<typename Levels::Level>& levels) {
  for (std::size_t i = 0; i < values.size(); i += 4) {
    const float alpha = values[i + 3];
    for (std::size_t c = 0; c < 3; ++c) levels[i + c] = alpha > 0 ? of.srgb(values[i + c] / alpha) : 0;
    levels[i + 3] = Levels::level(alpha);
  }
}

template <class Levels>
std::vector<typename Levels::Level> levels_of(const Film& film, int channel_count) {
  const Levels of;
  const std::vector<float>& values = film.values();
  std::vector<typename Levels::Level> levels(values.size() / static_cast<std::size_t>(channels(film.content())) *
                                             static_cast<std::size_t>(channel_count));
  const auto each = [&](auto&& level_of) { std::transform(values.begin(), values.end(), levels.begin(), level_of); };
  switch (film.content()) {
    case FilmContent::color:
      each([&](float value) { return of.srgb(value); });
      break;
    case FilmContent::color_alpha:
      divide_by_alpha(of, values, levels);
      break;
    case FilmContent::normal:
    case FilmContent::position:
      each(Levels::level);
      break;
    case FilmContent::depth:
      each([range = range_of(film)](float value) { return Levels::level(shade_of_depth(value, range)); });
      break;
    case FilmContent::length:
      each([range = range_of(film)](float value) { return Levels::level(shade_of_length(value, range[1])); });
      break;
    case FilmContent::id:
      color_ids<Levels>(values, levels);
      break;
  }
  return levels;
}

double clamped(double x) { return x > 0 ? std::min(x, 1.0) : 0; }  // not a number: 0

}  // namespace

std::uint8_t to_byte(double x) { return static_cast<std::uint8_t>(std::floor(clamped(x) * 255 + 0.5)); }

std::uint16_t to_word(double x) { return static_cast<std::uint16_t>(std::floor(clamped(x) * 65535 + 0.5)); }

EncodedFilm encode(const Film& film, int bits) {
  CSGCAST_PRECONDITION(bits == 8 || bits == 16);
  const FilmContent content = film.content();
  EncodedFilm result{film.width(), film.height(), content == FilmContent::id ? 3 : channels(content), content};
  if (bits == 8) {
    result.bytes = levels_of<Bytes>(film, result.channels);
  } else {
    result.words = levels_of<Words>(film, result.channels);
  }
  return result;
}

}  // namespace csgcast::detail
