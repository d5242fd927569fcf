// SPDX-License-Identifier: MIT
#include "shade/picture/detail/encode.h"

#include <algorithm>
#include <array>
#include <cmath>

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

// Neighbours mostly have the same id, and the same colour then.
void color_ids(const std::vector<float>& ids, std::vector<std::uint8_t>& bytes) {
  std::array<std::uint8_t, 3> color{};
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (i == 0 || ids[i] != ids[i - 1]) {
      const std::array<double, 3> channels = color_of_id(ids[i]);
      std::transform(channels.begin(), channels.end(), color.begin(), to_byte);
    }
    std::copy(color.begin(), color.end(), bytes.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
}

}  // namespace

std::uint8_t to_byte(double x) {
  if (!(x > 0)) return 0;
  return static_cast<std::uint8_t>(std::floor(std::min(x, 1.0) * 255 + 0.5));
}

EncodedFilm encode(const Film& film) {
  const FilmContent content = film.content();
  EncodedFilm result{film.width(), film.height(), content == FilmContent::id ? 3 : channels(content), content, {}};
  const std::vector<float>& values = film.values();
  result.bytes.resize(values.size() * static_cast<std::size_t>(result.channels / channels(content)));
  const auto each = [&](auto&& byte_of) {
    std::transform(values.begin(), values.end(), result.bytes.begin(), byte_of);
  };
  switch (content) {
    case FilmContent::color:
      each(SrgbBytes());
      break;
    case FilmContent::normal:
      each(to_byte);
      break;
    case FilmContent::depth:
      each([range = range_of(film)](float value) { return to_byte(shade_of_depth(value, range)); });
      break;
    case FilmContent::length:
      each([range = range_of(film)](float value) { return to_byte(shade_of_length(value, range[1])); });
      break;
    case FilmContent::id:
      color_ids(values, result.bytes);
      break;
  }
  return result;
}

}  // namespace csgcast::detail
