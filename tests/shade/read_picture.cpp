// SPDX-License-Identifier: MIT
#include "tests/shade/read_picture.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <png.h>
#include <tiffio.h>
// jpeglib.h needs <cstdio> before it:
// clang-format off
#include <cstdio>
#include <jpeglib.h>
// clang-format on

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace csgcast::test {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& why) { throw std::runtime_error(path + ": " + why); }

Picture of_bytes(int width, int height, int channels, const std::vector<std::uint8_t>& bytes) {
  Picture picture{width, height, 8, {"Y"}, {}};
  if (channels == 3) picture.channels = {"R", "G", "B"};
  for (const std::uint8_t byte : bytes) picture.values.push_back(static_cast<float>(byte / 255.0));
  return picture;
}

Picture read_png(const std::string& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) fail(path, image.message);
  if (image.format != PNG_FORMAT_RGB && image.format != PNG_FORMAT_GRAY) fail(path, "not grey or RGB of 8 bits");
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr) == 0) fail(path, image.message);
  return of_bytes(static_cast<int>(image.width), static_cast<int>(image.height),
                  static_cast<int>(PNG_IMAGE_PIXEL_CHANNELS(image.format)), bytes);
}

// Throws through libjpeg, which a test may.
void throw_error(j_common_ptr jpeg) {
  char text[JMSG_LENGTH_MAX];
  jpeg->err->format_message(jpeg, text);
  throw std::runtime_error(text);
}

Picture read_jpeg(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) fail(path, "cannot be opened");
  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  errors.error_exit = throw_error;
  jpeg_create_decompress(&jpeg);
  const std::unique_ptr<jpeg_decompress_struct, decltype(&jpeg_destroy_decompress)> owner(&jpeg,
                                                                                          jpeg_destroy_decompress);
  jpeg_stdio_src(&jpeg, file.get());
  jpeg_read_header(&jpeg, TRUE);
  jpeg_start_decompress(&jpeg);
  const std::size_t stride = std::size_t{jpeg.output_width} * static_cast<std::size_t>(jpeg.output_components);
  std::vector<std::uint8_t> bytes(stride * jpeg.output_height);
  while (jpeg.output_scanline < jpeg.output_height) {
    std::uint8_t* row = bytes.data() + stride * jpeg.output_scanline;
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  return of_bytes(static_cast<int>(jpeg.output_width), static_cast<int>(jpeg.output_height), jpeg.output_components,
                  bytes);
}

Picture read_tiff(const std::string& path) {
  const std::unique_ptr<TIFF, decltype(&TIFFClose)> file(TIFFOpen(path.c_str(), "r"), TIFFClose);
  if (!file) fail(path, "cannot be opened");
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint16_t channels = 0;
  std::uint16_t bits = 0;
  TIFFGetField(file.get(), TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(file.get(), TIFFTAG_IMAGELENGTH, &height);
  TIFFGetField(file.get(), TIFFTAG_SAMPLESPERPIXEL, &channels);
  TIFFGetField(file.get(), TIFFTAG_BITSPERSAMPLE, &bits);
  if (bits != 8) fail(path, "not of 8 bits");
  std::vector<std::uint8_t> bytes(std::size_t{width} * height * channels);
  for (std::uint32_t y = 0; y < height; ++y) {
    if (TIFFReadScanline(file.get(), bytes.data() + std::size_t{y} * width * channels, y) < 0) fail(path, "breaks off");
  }
  return of_bytes(static_cast<int>(width), static_cast<int>(height), channels, bytes);
}

Picture read_exr(const std::string& path) {
  Imf::InputFile file(path.c_str());
  const Imath::Box2i window = file.header().dataWindow();
  Picture picture{window.max.x + 1, window.max.y + 1, 32, {}, {}};
  for (auto channel = file.header().channels().begin(); channel != file.header().channels().end(); ++channel) {
    if (channel.channel().type != Imf::FLOAT) fail(path, "not of floats");
    picture.channels.insert(picture.channels.begin(), channel.name());  // a file has them by name: B, G, R
  }
  const std::size_t count = picture.channels.size();
  picture.values.resize(count * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  Imf::FrameBuffer frame;
  for (std::size_t i = 0; i < count; ++i) {
    frame.insert(picture.channels[i],
                 Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(picture.values.data() + i), count * sizeof(float),
                            count * sizeof(float) * static_cast<std::size_t>(picture.width)));
  }
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  return picture;
}

}  // namespace

Picture read_picture(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension();
  if (ending == ".png") return read_png(path);
  if (ending == ".jpg") return read_jpeg(path);
  if (ending == ".exr") return read_exr(path);
  return read_tiff(path);
}

}  // namespace csgcast::test
