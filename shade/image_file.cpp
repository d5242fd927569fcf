// SPDX-License-Identifier: MIT
#include "shade/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <limits>
#include <memory>

#include "csg/error.h"
#include "shade/detail/encode.h"
#include "shade/detail/whole_file.h"

namespace csgcast {
namespace {

struct Format {
  const char* ending;
  const char* plugin;  ///< OpenImageIO's name
  int longest_side;    ///< libjpeg ends the whole program at more than it can hold
};
constexpr int most = std::numeric_limits<int>::max();
constexpr std::array<Format, 6> formats{{{".png", "png", most},
                                         {".jpg", "jpeg", 65500},
                                         {".jpeg", "jpeg", 65500},
                                         {".tif", "tiff", most},
                                         {".tiff", "tiff", most},
                                         {".exr", "openexr", most}}};

const Format& format_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::string known;
  for (const Format& format : formats) {
    if (ending == format.ending) return format;
    known += known.empty() ? format.ending : std::string(", ") + format.ending;
  }
  const std::string what = ending.empty() ? "has no ending" : "ends in " + ending;
  throw Error(ErrorCode::usage, {path, 0, 0}, "not a known kind of picture", "its name " + what,
              "known endings are " + known);
}

OIIO::ImageSpec spec_of(const Film& film, const std::string& plugin, int channel_count, OIIO::TypeDesc type) {
  OIIO::ImageSpec spec(film.width(), film.height(), channel_count, type);
  const bool is_depth = film.content() == FilmContent::depth && type == OIIO::TypeDesc::FLOAT;
  if (channel_count == 3) {
    spec.channelnames = {"R", "G", "B"};
  } else {
    spec.channelnames = {is_depth ? "Z" : "Y"};
  }
  spec.attribute("Software", "csgcast");
  // Not for TIFF: OpenImageIO 2.4 then writes a file that no reader opens.
  const bool srgb = type == OIIO::TypeDesc::UINT8 && film.content() == FilmContent::color;
  if (srgb && plugin != "tiff") spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("jpeg:subsampling", "4:4:4");
  return spec;
}

// The bytes of the file that OpenImageIO makes of the pixels.
std::vector<unsigned char> compress(const std::string& path, const char* plugin, const OIIO::ImageSpec& spec,
                                    const void* pixels) {
  const auto fail = [&](const std::string& why) {
    throw Error(ErrorCode::input_output, {path, 0, 0}, "the picture cannot be encoded", why,
                "try another kind of file");
  };
  const auto output = OIIO::ImageOutput::create(plugin);
  if (!output) fail(OIIO::geterror());
  OIIO::Filesystem::IOVecOutput memory;
  if (!output->set_ioproxy(&memory) || !output->open(path, spec)) fail(output->geterror());
  if (!output->write_image(spec.format, pixels) || !output->close()) fail(output->geterror());
  return memory.buffer();
}

}  // namespace

void check_image_path(const std::string& path) { format_of(path); }

void write_image(const Film& film, const std::string& path) {
  const Format& format = format_of(path);
  if (film.width() > format.longest_side || film.height() > format.longest_side) {
    throw Error(ErrorCode::limit, {path, 0, 0}, "the picture is too large for this kind of file",
                "it holds at most " + std::to_string(format.longest_side) + " pixels a side", "write a .png or .exr");
  }
  std::vector<unsigned char> bytes;
  if (format.plugin == std::string("openexr")) {
    const OIIO::ImageSpec spec = spec_of(film, format.plugin, channels(film.content()), OIIO::TypeDesc::FLOAT);
    bytes = compress(path, format.plugin, spec, film.values().data());
  } else {
    const detail::EncodedFilm encoded = detail::encode(film);
    const OIIO::ImageSpec spec = spec_of(film, format.plugin, encoded.channels, OIIO::TypeDesc::UINT8);
    bytes = compress(path, format.plugin, spec, encoded.bytes.data());
  }
  detail::write_whole_file(path, std::as_bytes(std::span(bytes)));
}

}  // namespace csgcast
