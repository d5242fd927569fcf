// SPDX-License-Identifier: MIT
#include "shade/picture/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "csg/base/error.h"
#include "csg/base/precondition.h"
#include "csg/file/whole_file.h"
#include "shade/module/picture_module.h"
#include "shade/picture/detail/encode.h"
#include "shade/picture/detail/png_file.h"

namespace csgcast {
namespace {

/// Numbers of bits, as a set.
enum Bits : unsigned { b8 = 1, b16 = 2, b32 = 4 };

struct Format {
  const char* ending;
  unsigned bits;  ///< the least of the set is usual
  int longest_side = std::numeric_limits<int>::max();
  bool has_alpha = true;
  bool has_gray = true;  ///< pictures of one channel
};
constexpr int most = std::numeric_limits<int>::max();
constexpr int jpeg_side = 65500;
constexpr int webp_side = 16383;
constexpr int word_side = 65535;
constexpr int icon_side = 256;
constexpr std::array formats{Format{".png", b8 | b16},
                             Format{".jpg", b8, jpeg_side, false},
                             Format{".jpeg", b8, jpeg_side, false},
                             Format{".tif", b8 | b16 | b32},
                             Format{".tiff", b8 | b16 | b32},
                             Format{".exr", b32},
                             Format{".hdr", b32, most, false, false},
                             Format{".webp", b8, webp_side},
                             Format{".bmp", b8},
                             Format{".tga", b8, word_side},
                             Format{".ppm", b8, most, false},
                             Format{".pgm", b8, most, false},
                             Format{".gif", b8, word_side, true, false},
                             Format{".jp2", b8 | b16},
                             Format{".dpx", b8 | b16},
                             Format{".sgi", b8 | b16, word_side},
                             Format{".iff", b8 | b16, word_side, true, false},
                             Format{".ico", b8, icon_side}};

unsigned set_of(int bits) {
  if (bits == 8) return b8;
  if (bits == 16) return b16;
  return bits == 32 ? b32 : 0U;
}

std::string list_of(unsigned bits) {
  std::string list;
  for (const int count : {8, 16, 32}) {
    if ((bits & set_of(count)) != 0) list += (list.empty() ? "" : ", ") + std::to_string(count);
  }
  return list;
}

std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

const Format& format_of(const std::string& path) {
  const std::string ending = ending_of(path);
  std::string known;
  for (const Format& format : formats) {
    if (ending == format.ending) return format;
    known += known.empty() ? format.ending : std::string(", ") + format.ending;
  }
  const std::string what = ending.empty() ? "has no ending" : "ends in " + ending;
  throw Error(ErrorCode::usage, {path, 0, 0}, "not a known kind of picture", "its name " + what,
              "known endings are " + known);
}

/// The number of bits that are asked for, or the usual one.
int bits_of(const std::string& path, const Format& format, const PictureOptions& options) {
  if (options.bits == 0) return (format.bits & b8) != 0 ? 8 : 32;
  if ((set_of(options.bits) & format.bits) != 0) return options.bits;
  throw Error(
      ErrorCode::usage, {path, 0, 0}, fmt::format("{} bits a channel do not fit this kind of picture", options.bits),
      fmt::format("{} files hold {}", format.ending, list_of(format.bits)), "choose one of these, or another kind");
}

bool is_plain_png(const Format& format, int bits) { return format.ending == std::string_view(".png") && bits == 8; }

bool is_srgb(FilmContent content) { return content == FilmContent::color || content == FilmContent::color_alpha; }

/// The channels of a film's file, or of a film's layer in one.
std::vector<std::string> names_of(FilmContent content, int channels) {
  if (channels == 1) return {content == FilmContent::depth ? "Z" : "Y"};
  if (channels == 4) return {"R", "G", "B", "A"};
  return {"R", "G", "B"};
}

/// The endings of all kinds of files with something.
std::string endings_with(bool Format::*feature) {
  std::string endings;
  for (const Format& format : formats) {
    if (format.*feature) endings += (endings.empty() ? "" : ", ") + std::string(format.ending);
  }
  return endings;
}

void check_content(FilmContent content, const Format& format, int bits, const std::string& path) {
  if (content == FilmContent::color_alpha && !format.has_alpha) {
    throw Error(ErrorCode::usage, {path, 0, 0}, "this kind of picture has no transparency",
                fmt::format("{} files hold colours alone", format.ending),
                "these do: " + endings_with(&Format::has_alpha));
  }
  const bool is_gray = channels(content) == 1 && (content != FilmContent::id || bits == 32);
  if (is_gray && !format.has_gray) {
    throw Error(ErrorCode::usage, {path, 0, 0}, "this kind of picture has no single channel, as depths need it",
                fmt::format("{} files hold colours alone", format.ending),
                "these do: " + endings_with(&Format::has_gray));
  }
}

void check_size(const Film& film, const Format& format, const std::string& path) {
  if (film.width() <= format.longest_side && film.height() <= format.longest_side) return;
  throw Error(ErrorCode::limit, {path, 0, 0}, "the picture is too large for this kind of file",
              fmt::format("it holds at most {} pixels a side", format.longest_side), "write a .png or .exr");
}

std::vector<std::pair<std::string, std::string>> all_notes(const PictureOptions& options) {
  std::vector<std::pair<std::string, std::string>> notes{{"Software", "csgcast " CSGCAST_VERSION}};
  notes.insert(notes.end(), options.notes.begin(), options.notes.end());
  return notes;
}

/// Calls what makes the bytes, and tells what its library says.
template <class Encode>
std::vector<std::byte> encoded(const std::string& path, Encode&& encode) {
  try {
    return encode();
  } catch (const Error&) {
    throw;
  } catch (const std::runtime_error& failure) {
    throw Error(ErrorCode::machine, {path, 0, 0}, "the picture cannot be encoded", failure.what(),
                "try another kind of file");
  }
}

}  // namespace

void check_image_path(const std::string& path, const PictureOptions& options) {
  const Format& format = format_of(path);
  const int bits = bits_of(path, format, options);
  check_content(options.content, format, bits, path);
  if (!is_plain_png(format, bits)) detail::prepare_picture_module();
}

std::vector<std::byte> image_bytes(const Film& film, const std::string& path, const PictureOptions& options) {
  const Format& format = format_of(path);
  const int bits = bits_of(path, format, options);
  check_size(film, format, path);
  check_content(film.content(), format, bits, path);
  detail::EncodedPicture picture{.width = film.width(), .height = film.height(), .notes = all_notes(options)};
  if (bits == 32) {
    picture.type = detail::PixelType::real;
    picture.channels = names_of(film.content(), channels(film.content()));
    picture.pixels = film.values().data();
    return encoded(path, [&] { return detail::picture_module({path, 0, 0}).encode(picture, ending_of(path)); });
  }
  const detail::EncodedFilm levels = detail::encode(film, bits);
  if (is_plain_png(format, bits)) return encoded(path, [&] { return detail::png_file(levels, picture.notes); });
  picture.type = bits == 8 ? detail::PixelType::byte : detail::PixelType::word;
  picture.channels = names_of(film.content(), levels.channels);
  picture.pixels = bits == 8 ? static_cast<const void*>(levels.bytes.data()) : levels.words.data();
  picture.is_srgb = is_srgb(film.content());
  return encoded(path, [&] { return detail::picture_module({path, 0, 0}).encode(picture, ending_of(path)); });
}

void write_image(const Film& film, const std::string& path, const PictureOptions& options) {
  const std::vector<std::byte> bytes = image_bytes(film, path, options);
  WholeFile file(path);
  file.write(bytes);
  file.commit();
}

bool holds_layers(const std::string& path) { return ending_of(path) == ".exr"; }

std::vector<std::byte> layer_bytes(std::span<const NamedChannels> layers, const std::string& path,
                                   const PictureOptions& options) {
  CSGCAST_PRECONDITION(!layers.empty());
  const Format& format = format_of(path);
  if (!holds_layers(path)) {
    throw Error(ErrorCode::usage, {path, 0, 0}, "this kind of picture holds no channels by name",
                fmt::format("{} files hold one picture", format.ending), "write an .exr");
  }
  static_cast<void>(bits_of(path, format, options));
  const int width = layers.front().film->width();
  const int height = layers.front().film->height();
  detail::EncodedPicture picture{
      .width = width, .height = height, .type = detail::PixelType::real, .notes = all_notes(options)};
  for (const NamedChannels& layer : layers) {
    CSGCAST_PRECONDITION(layer.film->width() == width && layer.film->height() == height);
    CSGCAST_PRECONDITION(static_cast<int>(layer.channels.size()) == channels(layer.film->content()));
    picture.channels.insert(picture.channels.end(), layer.channels.begin(), layer.channels.end());
  }
  std::vector<float> values;
  values.reserve(picture.channels.size() * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const NamedChannels& layer : layers) {
        for (int c = 0; c < channels(layer.film->content()); ++c) values.push_back(layer.film->value(x, y, c));
      }
    }
  }
  picture.pixels = values.data();
  return encoded(path, [&] { return detail::picture_module({path, 0, 0}).encode(picture, ending_of(path)); });
}

}  // namespace csgcast
