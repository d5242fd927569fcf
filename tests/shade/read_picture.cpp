// SPDX-License-Identifier: MIT
#include "tests/shade/read_picture.h"

#include <png.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "shade/module/picture_module.h"

namespace csgcast::test {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& why) { throw std::runtime_error(path + ": " + why); }

Picture of_bytes(int width, int height, int channels, const std::vector<std::uint8_t>& bytes) {
  Picture picture{width, height, 8, true, {"Y"}, {}, {}};
  if (channels >= 3) picture.channels = {"R", "G", "B"};
  if (channels == 4) picture.channels.emplace_back("A");
  for (const std::uint8_t byte : bytes) picture.values.push_back(static_cast<float>(byte / 255.0));
  return picture;
}

Picture read_png(const std::string& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) fail(path, image.message);
  if (image.format == PNG_FORMAT_LINEAR_RGB) fail(path, "not of 8 bits");
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr) == 0) fail(path, image.message);
  return of_bytes(static_cast<int>(image.width), static_cast<int>(image.height),
                  static_cast<int>(PNG_IMAGE_PIXEL_CHANNELS(image.format)), bytes);
}

Picture read_by_module(const std::string& path) {
  detail::DecodedPicture decoded = detail::picture_module({path, 0, 0}).decode(path, std::size_t{1} << 24);
  return {decoded.width, decoded.height, decoded.bits, decoded.is_srgb, decoded.channels, std::move(decoded.values),
          decoded.notes};
}

}  // namespace

Picture read_picture(const std::string& path) {
  const bool is_png = std::filesystem::path(path).extension() == ".png";
  std::ifstream file(path, std::ios::binary);
  std::array<char, 25> head{};
  file.read(head.data(), head.size());
  constexpr std::size_t bits = 24;  // where a PNG tells them
  return is_png && head[bits] == 8 ? read_png(path) : read_by_module(path);
}

}  // namespace csgcast::test
