// SPDX-License-Identifier: MIT
#include <sys/resource.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

#include "csg/base/error.h"
#include "csg/file/whole_file.h"
#include "shade/picture/detail/encode.h"
#include "shade/picture/detail/png_file.h"
#include "shade/picture/detail/srgb_bytes.h"
#include "shade/picture/image_file.h"
#include "tests/shade/read_picture.h"
#include "tests/support/catch.h"

using namespace csgcast;
using test::Picture;
using test::read_picture;
namespace fs = std::filesystem;

namespace {

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("csgcast-test-" + std::to_string(std::random_device()()))) {
    fs::create_directory(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::size_t count() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), {})); }

 private:
  fs::path path_;
};

Film ramp() {
  Film film(16, 3, FilmContent::color);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 16; ++x) film.set(x, y, {x / 15.0, 0.5 * y, 1.5 - x * 0.1});
  }
  return film;
}

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("EXR keeps the linear numbers to the last bit") {
  const Folder folder;
  const Film film = ramp();
  write_image(film, folder.file("a.exr"));
  const Picture read = read_picture(folder.file("a.exr"));
  REQUIRE(read.width == 16);
  REQUIRE(read.height == 3);
  REQUIRE(read.bits == 32);
  REQUIRE(read.channels == std::vector<std::string>{"R", "G", "B"});
  REQUIRE(read.values == film.values());
}

TEST_CASE("PNG and TIFF hold sRGB in 8 bits, rounded to the nearest and clamped") {
  const Folder folder;
  const Film film = ramp();
  for (const char* name : {"a.png", "a.tif", "a.TIFF"}) {
    write_image(film, folder.file(name));
    const Picture read = read_picture(folder.file(name));
    REQUIRE(read.bits == 8);
    REQUIRE(read.channels.size() == 3);
    REQUIRE(read.values.size() == film.values().size());
    for (std::size_t i = 0; i < read.values.size(); ++i) {
      const double encoded = srgb_from_linear(std::fmin(film.values()[i], 1.0));
      REQUIRE(std::fabs(255 * double(read.values[i]) - 255 * encoded) <= 0.5001);
    }
  }
}

TEST_CASE("kinds of pictures without loss read back equal, with 8 and 16 bits") {
  const Folder folder;
  const Film film = ramp();
  for (const auto& [name, bits] : std::vector<std::pair<const char*, int>>{{"a.png", 8},
                                                                           {"a.png", 16},
                                                                           {"a.tif", 8},
                                                                           {"a.tif", 16},
                                                                           {"a.webp", 8},
                                                                           {"a.tga", 8},
                                                                           {"a.bmp", 8},
                                                                           {"a.ppm", 8},
                                                                           {"a.dpx", 16},
                                                                           {"a.sgi", 8}}) {
    INFO(name << " with " << bits << " bits");
    write_image(film, folder.file(name), {.bits = bits});
    const Picture read = read_picture(folder.file(name));
    CHECK(read.bits == bits);
    CHECK((read.width == film.width() && read.height == film.height()));
    const detail::EncodedFilm levels = detail::encode(film, bits);
    REQUIRE(read.values.size() == film.values().size());
    bool is_equal = true;
    for (std::size_t i = 0; i < read.values.size(); ++i) {
      const int wanted = bits == 8 ? levels.bytes[i] : levels.words[i];
      is_equal = is_equal && std::lround(double(read.values[i]) * (bits == 8 ? 255 : 65535)) == wanted;
    }
    CHECK(is_equal);
  }
}

TEST_CASE(
    "TIFF with 32 bits keeps the linear numbers, and Radiance to one part in 128 of a pixel's brightest channel") {
  const Folder folder;
  const Film film = ramp();
  write_image(film, folder.file("a.tif"), {.bits = 32});
  CHECK(read_picture(folder.file("a.tif")).values == film.values());
  write_image(film, folder.file("a.hdr"));
  const Picture read = read_picture(folder.file("a.hdr"));
  REQUIRE(read.values.size() == film.values().size());
  for (std::size_t i = 0; i < read.values.size(); i += 3) {
    const float* wanted = &film.values()[i];
    const double step = std::max({wanted[0], wanted[1], wanted[2]}) / 128;
    for (std::size_t c = 0; c < 3; ++c) CHECK(std::fabs(double(read.values[i + c]) - double(wanted[c])) <= step);
  }
}

TEST_CASE("16 bits are sRGB, rounded to the nearest") {
  Film film(4, 1, FilmContent::color);
  film.set(0, 0, {0, 1e-5, 0.2});
  film.set(1, 0, {0.5, 0.99999, 1});
  film.set(2, 0, {2, -1, 0.25});
  const detail::EncodedFilm words = detail::encode(film, 16);
  for (std::size_t i = 0; i < words.words.size(); ++i) {
    const double linear = std::clamp(double(film.values()[i]), 0.0, 1.0);
    CHECK(std::fabs(words.words[i] - 65535 * srgb_from_linear(linear)) <= 0.5001);
  }
}

TEST_CASE("alpha is told apart from the colours with 8 and 16 bits, and multiplied into them in floats") {
  const Folder folder;
  Film film(2, 1, FilmContent::color_alpha);
  const float values[8] = {0.25F, 0.125F, 0, 0.5F, 0, 0, 0, 0};
  for (int i = 0; i < 8; ++i) film.value(i / 4, 0, i % 4) = values[i];
  for (const char* name : {"a.png", "a.tif", "a.tga", "a.webp"}) {
    INFO(name);
    write_image(film, folder.file(name));
    const Picture read = read_picture(folder.file(name));
    REQUIRE(read.channels.size() == 4);
    CHECK(std::lround(255 * double(read.values[3])) == 128);
    CHECK(std::lround(255 * double(read.values[7])) == 0);
  }
  const std::vector<std::uint8_t> bytes = detail::encode(film).bytes;
  CHECK(bytes[0] == detail::to_byte(srgb_from_linear(0.5)));
  CHECK(bytes[3] == 128);
  write_image(film, folder.file("a.exr"));
  const Picture read = read_picture(folder.file("a.exr"));
  CHECK(read.channels == std::vector<std::string>{"R", "G", "B", "A"});
  CHECK(read.values == film.values());
  CHECK_THROWS_AS(write_image(film, folder.file("a.jpg")), Error);
}

TEST_CASE("bits that a kind of picture does not hold are refused, with those that it does") {
  CHECK_THROWS_WITH(check_image_path("a.jpg", {.bits = 16}), Catch::Contains(".jpg files hold 8"));
  CHECK_THROWS_WITH(check_image_path("a.png", {.bits = 32}), Catch::Contains(".png files hold 8, 16"));
  CHECK_THROWS_WITH(check_image_path("a.exr", {.bits = 8}), Catch::Contains(".exr files hold 32"));
}

TEST_CASE("channels by name and notes are in the file") {
  const Folder folder;
  Film depth(3, 2, FilmContent::depth);
  Film place(3, 2, FilmContent::position);
  for (int i = 0; i < 6; ++i) {
    depth.value(i % 3, i / 3) = static_cast<float>(i);
    for (int c = 0; c < 3; ++c) place.value(i % 3, i / 3, c) = static_cast<float>(10 * i + c);
  }
  const std::vector<NamedChannels> channels{{&depth, {"Z"}}, {&place, {"P.X", "P.Y", "P.Z"}}};
  WholeFile file(folder.file("a.exr"));
  file.write(layer_bytes(channels, folder.file("a.exr"), {0, {{"Camera", "eye 1, 2, 3"}}}));
  file.commit();
  const Picture read = read_picture(folder.file("a.exr"));
  const auto channel = [&](const char* name) {
    return static_cast<std::size_t>(std::find(read.channels.begin(), read.channels.end(), name) -
                                    read.channels.begin());
  };
  REQUIRE(read.channels.size() == 4);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(read.values[4 * i + channel("Z")] == static_cast<float>(i));
    CHECK(read.values[4 * i + channel("P.Y")] == static_cast<float>(10 * i + 1));
  }
  const auto has = [&](const std::string& name, const std::string& text) {
    return std::any_of(read.notes.begin(), read.notes.end(),
                       [&](const auto& note) { return note.first == name && note.second.find(text) == 0; });
  };
  CHECK(has("Camera", "eye 1, 2, 3"));
  CHECK(has("Software", "csgcast "));
  CHECK_THROWS_WITH(layer_bytes(channels, "a.png"), Catch::Contains("write an .exr"));
}

TEST_CASE("kinds of files for colours alone refuse pictures of one channel, before and when they are made") {
  const Folder folder;
  const Film depth(3, 2, FilmContent::depth);
  const Film id(3, 2, FilmContent::id);
  for (const char* name : {"a.hdr", "a.gif", "a.iff"}) {
    CHECK_THROWS_WITH(check_image_path(name, {.content = FilmContent::length}), Catch::Contains("no single channel"));
    CHECK_THROWS_WITH(image_bytes(depth, name), Catch::Contains("hold colours alone"));
  }
  CHECK_THROWS_WITH(image_bytes(id, "a.hdr"), Catch::Contains("no single channel"));
  CHECK_NOTHROW(write_image(id, folder.file("a.gif")));  // its numbers are colours there
}

TEST_CASE("notes in a .png are UTF-8") {
  const Folder folder;
  write_image(ramp(), folder.file("a.png"), {.notes = {{"Scene", "\u00e9\u00df.csg"}}});
  const std::string bytes = content_of(folder.file("a.png"));
  CHECK(bytes.find(std::string("iTXtScene\0\0\0\0\0", 14) + "\u00e9\u00df.csg") != std::string::npos);
  CHECK(bytes.find("tEXtSoftware") != std::string::npos);
}

TEST_CASE("JPEG is close to the picture") {
  const Folder folder;
  Film film(32, 32, FilmContent::color);
  for (int i = 0; i < 32 * 32; ++i) film.set(i % 32, i / 32, {0.5, 0.2, 0.1});
  write_image(film, folder.file("a.jpg"));
  const Picture read = read_picture(folder.file("a.jpg"));
  REQUIRE(std::fabs(double(read.values[0]) - srgb_from_linear(0.5)) < 3 / 255.0);
}

TEST_CASE("lengths are one grey channel in PNG, TIFF and JPEG, byte by byte in the first two") {
  const Folder folder;
  Film film(70, 40, FilmContent::length);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 70; ++x) film.value(x, y) = static_cast<float>(x + 2 * y);
  }
  const std::vector<std::uint8_t> bytes = detail::encode(film).bytes;
  for (const char* name : {"a.png", "a.tif", "a.jpg"}) {
    write_image(film, folder.file(name));
    const Picture read = read_picture(folder.file(name));
    REQUIRE(read.channels.size() == 1);
    REQUIRE(read.values.size() == bytes.size());
    const double tolerance = name == std::string("a.jpg") ? 3 : 1e-4;
    for (std::size_t i = 0; i < bytes.size(); ++i)
      REQUIRE(std::fabs(255 * double(read.values[i]) - bytes[i]) <= tolerance);
  }
}

TEST_CASE("the same picture makes the same file, in every kind and at any time") {
  const Folder folder;
  const std::chrono::year_month_day today(std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
  const std::string year = std::to_string(static_cast<int>(today.year())) + ':';
  for (const char* ending : {".png", ".tif", ".jpg", ".exr", ".webp", ".tga", ".dpx", ".jp2", ".hdr"}) {
    INFO(ending);
    const auto file = [&](const char* name) {
      write_image(ramp(), folder.file(std::string(name) + ending));
      return content_of(folder.file(std::string(name) + ending));
    };
    const std::string first = file("a");
    REQUIRE(first.find(year) == std::string::npos);  // a second writing within the same second would not show a date
    REQUIRE((file("b") == first));
  }
}

TEST_CASE("the table of sRGB bytes says what the curve says, wherever the byte changes and in between") {
  const detail::SrgbBytes byte_of;
  const auto check = [&](float x) {
    if (byte_of(x) != detail::to_byte(srgb_from_linear(std::min(x, 1.0F)))) FAIL("differs at " << x);
  };
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (int byte = 1; byte < 256; ++byte) {
    float x = static_cast<float>(linear_from_srgb((byte - 0.5) / 255));
    for (int i = 0; i < 50; ++i) x = std::nextafter(x, 0.0F);
    for (int i = 0; i < 100; ++i, x = std::nextafter(x, infinity)) check(x);
  }
  for (std::uint32_t bits = 0; bits < 0x7f800000; bits += 1021) check(std::bit_cast<float>(bits));
  for (const float x : {0.0F, -0.0F, -1.0F, 1.0F, 2.0F, infinity, -infinity, std::nanf("")}) check(x);
}

TEST_CASE("bytes are rounded half up, clamped, and 0 for what is no number") {
  using detail::to_byte;
  REQUIRE(to_byte(-1) == 0);
  REQUIRE(to_byte(std::nan("")) == 0);
  REQUIRE(to_byte(2) == 255);
  REQUIRE(to_byte(std::numeric_limits<double>::infinity()) == 255);
  REQUIRE(to_byte(0.499 / 255) == 0);
  REQUIRE(to_byte(0.501 / 255) == 1);
  REQUIRE(to_byte(254.499 / 255) == 254);
}

TEST_CASE("depths keep their numbers in EXR, and in 8 bits go from white to dark before black") {
  const Folder folder;
  Film film(4, 1, FilmContent::depth);
  film.value(0, 0) = 3;
  film.value(1, 0) = 5;
  film.value(2, 0) = 7;
  film.value(3, 0) = std::numeric_limits<float>::infinity();
  write_image(film, folder.file("a.exr"));
  const Picture read = read_picture(folder.file("a.exr"));
  REQUIRE(read.channels == std::vector<std::string>{"Z"});
  REQUIRE(read.values == film.values());
  const std::vector<std::uint8_t> bytes = detail::encode(film).bytes;
  REQUIRE(bytes == std::vector<std::uint8_t>{255, 143, 31, 0});
}

TEST_CASE("lengths in 8 bits go from black to white, infinite ones are white") {
  Film film(4, 1, FilmContent::length);
  film.value(1, 0) = 1;
  film.value(2, 0) = 4;
  film.value(3, 0) = std::numeric_limits<float>::infinity();
  REQUIRE(detail::encode(film).bytes == std::vector<std::uint8_t>{0, 64, 255, 255});
  Film empty(2, 1, FilmContent::length);
  REQUIRE(detail::encode(empty).bytes == std::vector<std::uint8_t>{0, 0});
}

TEST_CASE("neighbouring ids get unlike colours, nothing is black, and EXR has the numbers") {
  const Folder folder;
  Film film(100, 1, FilmContent::id);
  for (int x = 0; x < 100; ++x) film.value(x, 0) = static_cast<float>(x - 1);
  const std::vector<std::uint8_t> bytes = detail::encode(film).bytes;
  REQUIRE((bytes[0] == 0 && bytes[1] == 0 && bytes[2] == 0));
  for (std::size_t x = 1; x + 1 < 100; ++x) {
    int difference = 0;
    for (std::size_t c = 0; c < 3; ++c) difference += std::abs(bytes[3 * x + c] - bytes[3 * x + 3 + c]);
    REQUIRE(difference > 100);
  }
  write_image(film, folder.file("a.exr"));
  REQUIRE(read_picture(folder.file("a.exr")).values == film.values());
}

TEST_CASE("unknown endings are refused with the list of known ones") {
  for (const char* name : {"a.stl", "a", "png", ".png/", "a.png.gz", ""}) {
    REQUIRE_THROWS_WITH(check_image_path(name), Catch::Contains(".png, .jpg, .jpeg, .tif, .tiff, .exr, .hdr, .webp"));
  }
  for (const char* name : {"a.png", "b/a.JPG", "a.jpeg", "a.tif", "a.Tiff", "a.exr"})
    REQUIRE_NOTHROW(check_image_path(name));
}

TEST_CASE("a picture replaces an older file and leaves nothing else behind") {
  const Folder folder;
  std::ofstream(folder.file("a.png")) << "old";
  write_image(ramp(), folder.file("a.png"));
  REQUIRE(content_of(folder.file("a.png")) != "old");
  REQUIRE(folder.count() == 1);
}

TEST_CASE("a link is kept, and what it points to is replaced") {
  const Folder folder;
  std::ofstream(folder.file("real.png")) << "old";
  fs::create_symlink(folder.file("real.png"), folder.file("link.png"));
  write_image(ramp(), folder.file("link.png"));
  REQUIRE(fs::is_symlink(folder.file("link.png")));
  REQUIRE(content_of(folder.file("real.png")) != "old");
  REQUIRE(folder.count() == 2);
}

TEST_CASE("a folder that does not exist, or one in the file's place, is told as such and nothing is left behind") {
  const Folder folder;
  REQUIRE_THROWS_WITH(write_image(ramp(), folder.file("no/a.png")), Catch::Contains("No such file or directory"));
  fs::create_directory(folder.file("a.png"));
  REQUIRE_THROWS_WITH(write_image(ramp(), folder.file("a.png")), Catch::Contains("Is a directory"));
  REQUIRE(folder.count() == 1);
}

TEST_CASE("a picture that a format cannot hold leaves the old file untouched and no temporary") {
  const Folder folder;  // JPEG holds at most 65,500 pixels a side
  const std::string jpeg = folder.file("a.jpg");
  std::ofstream(jpeg) << "old";
  REQUIRE_THROWS_AS(write_image(Film(65501, 1, FilmContent::length), jpeg), Error);
  REQUIRE(content_of(jpeg) == "old");
  REQUIRE(folder.count() == 1);
}

TEST_CASE("what a picture's library refuses is told in its words, and the old file stays") {
  const Folder folder;
  const std::string png = folder.file("a.png");
  std::ofstream(png) << "old";
  const Film wide(1'000'001, 1, FilmContent::length);  // one pixel more than libpng takes
  REQUIRE_THROWS_WITH(write_image(wide, png), Catch::Contains("cannot be encoded (Invalid IHDR data)"));
  REQUIRE(content_of(png) == "old");
  REQUIRE(folder.count() == 1);
  const std::string icon = folder.file("a.ico");
  std::ofstream(icon) << "old";
  REQUIRE_THROWS_WITH(write_image(Film(300, 1, FilmContent::length), icon),
                      Catch::Contains("at most 256 pixels a side"));
  REQUIRE(content_of(icon) == "old");
}

TEST_CASE("what is no regular file is written to and not replaced") {
  const Folder folder;
  fs::create_symlink("/dev/null", folder.file("null.png"));
  write_image(ramp(), folder.file("null.png"));
  REQUIRE(fs::is_symlink(folder.file("null.png")));
  REQUIRE(fs::is_character_file("/dev/null"));
}

TEST_CASE("a disk that takes no more is told as such, the old file stays and no temporary does") {
  const Folder folder;
  const std::string path = folder.file("a.png");
  std::ofstream(path) << "old";
  // No file may grow beyond 16 bytes: writing fails just as it does on a full disk.
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit tight{16, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &tight);
  std::string problem;
  try {
    write_image(ramp(), path);
  } catch (const Error& error) {
    problem = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  REQUIRE_THAT(problem, Catch::Contains("File too large"));
  REQUIRE(content_of(path) == "old");
  REQUIRE(folder.count() == 1);
}
