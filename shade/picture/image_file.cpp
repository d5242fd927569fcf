// SPDX-License-Identifier: MIT
#include "shade/picture/image_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <limits>
#include <vector>

#include "csg/base/error.h"
#include "csg/base/whole_file.h"
#include "shade/picture/detail/encode.h"
#include "shade/picture/detail/picture_formats.h"

namespace csgcast {
namespace {

using Bytes = std::vector<std::byte>;
Bytes png(const Film& film) { return detail::png_file(detail::encode(film)); }
Bytes jpeg(const Film& film) { return detail::jpeg_file(detail::encode(film)); }
Bytes tiff(const Film& film) { return detail::tiff_file(detail::encode(film)); }

struct Format {
  const char* ending;
  Bytes (*file_of)(const Film& film);
  int longest_side;
};
constexpr int most = std::numeric_limits<int>::max();
constexpr int most_jpeg = 65500;
constexpr std::array<Format, 6> formats{{{".png", png, most},
                                         {".jpg", jpeg, most_jpeg},
                                         {".jpeg", jpeg, most_jpeg},
                                         {".tif", tiff, most},
                                         {".tiff", tiff, most},
                                         {".exr", detail::exr_file, most}}};

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

}  // namespace

void check_image_path(const std::string& path) { format_of(path); }

std::vector<std::byte> image_bytes(const Film& film, const std::string& path) {
  const Format& format = format_of(path);
  if (film.width() > format.longest_side || film.height() > format.longest_side) {
    throw Error(ErrorCode::limit, {path, 0, 0}, "the picture is too large for this kind of file",
                "it holds at most " + std::to_string(format.longest_side) + " pixels a side", "write a .png or .exr");
  }
  try {
    return format.file_of(film);
  } catch (const detail::PictureFailure& failure) {
    throw Error(ErrorCode::machine, {path, 0, 0}, "the picture cannot be encoded", failure.what(),
                "try another kind of file");
  }
}

void write_image(const Film& film, const std::string& path) {
  const Bytes bytes = image_bytes(film, path);
  WholeFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace csgcast
