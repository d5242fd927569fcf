// SPDX-License-Identifier: MIT
#include <OpenImageIO/imageio.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

#include "csg/error.h"
#include "shade/detail/encode.h"
#include "shade/image_file.h"
#include "tests/support/catch.h"

using namespace csgcast;
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

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;
  std::vector<float> values;
};

Picture read_back(const std::string& path, OIIO::TypeDesc stored_as) {
  const auto input = OIIO::ImageInput::open(path);
  INFO(path << ": " << OIIO::geterror());
  REQUIRE(input);
  const OIIO::ImageSpec& spec = input->spec();
  REQUIRE(spec.format == stored_as);
  Picture picture{spec.width, spec.height, spec.channelnames, {}};
  picture.values.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
  REQUIRE(input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, picture.values.data()));
  return picture;
}

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
  const Picture read = read_back(folder.file("a.exr"), OIIO::TypeDesc::FLOAT);
  REQUIRE(read.width == 16);
  REQUIRE(read.height == 3);
  REQUIRE(read.channels == std::vector<std::string>{"R", "G", "B"});
  REQUIRE(read.values == film.values());
}

TEST_CASE("PNG and TIFF hold sRGB in 8 bits, rounded to the nearest and clamped") {
  const Folder folder;
  const Film film = ramp();
  for (const char* name : {"a.png", "a.tif", "a.TIFF"}) {
    write_image(film, folder.file(name));
    const Picture read = read_back(folder.file(name), OIIO::TypeDesc::UINT8);
    REQUIRE(read.values.size() == film.values().size());
    for (std::size_t i = 0; i < read.values.size(); ++i) {
      const double encoded = srgb_from_linear(std::fmin(film.values()[i], 1.0));
      REQUIRE(std::fabs(255 * double(read.values[i]) - 255 * encoded) <= 0.5001);
    }
  }
}

TEST_CASE("JPEG is close to the picture") {
  const Folder folder;
  Film film(32, 32, FilmContent::color);
  for (int i = 0; i < 32 * 32; ++i) film.set(i % 32, i / 32, {0.5, 0.2, 0.1});
  write_image(film, folder.file("a.jpg"));
  const Picture read = read_back(folder.file("a.jpg"), OIIO::TypeDesc::UINT8);
  REQUIRE(std::fabs(double(read.values[0]) - srgb_from_linear(0.5)) < 3 / 255.0);
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
  const Picture read = read_back(folder.file("a.exr"), OIIO::TypeDesc::FLOAT);
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
  REQUIRE(read_back(folder.file("a.exr"), OIIO::TypeDesc::FLOAT).values == film.values());
}

TEST_CASE("unknown endings are refused with the list of known ones") {
  for (const char* name : {"a.stl", "a", "png", ".png/", "a.png.gz", ""}) {
    REQUIRE_THROWS_WITH(check_image_path(name), Catch::Contains(".png, .jpg, .jpeg, .tif, .tiff, .exr"));
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
  REQUIRE_THROWS_WITH(write_image(ramp(), folder.file("a.png")), Catch::Contains("not a regular file"));
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

TEST_CASE("what is no regular file is not replaced") {
  const Folder folder;
  fs::create_symlink("/dev/null", folder.file("null.png"));
  REQUIRE_THROWS_WITH(write_image(ramp(), folder.file("null.png")), Catch::Contains("not a regular file"));
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
