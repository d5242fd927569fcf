// SPDX-License-Identifier: MIT
// The module for pictures: the only file that knows OpenImageIO.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>
#include <unistd.h>
#include <webp/encode.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "shade/module/module_version.h"
#include "shade/module/picture_module.h"

namespace csgcast::detail {
namespace {

constexpr int jpeg_quality = 98;  // edges show no ripples yet

OIIO::TypeDesc type_of(PixelType type) {
  switch (type) {
    case PixelType::byte:
      return OIIO::TypeUInt8;
    case PixelType::word:
      return OIIO::TypeUInt16;
    case PixelType::real:
      break;
  }
  return OIIO::TypeFloat;
}

OIIO::ImageSpec spec_of(const EncodedPicture& picture, const std::string& ending) {
  OIIO::ImageSpec spec(picture.width, picture.height, static_cast<int>(picture.channels.size()), type_of(picture.type));
  spec.channelnames = picture.channels;
  spec.alpha_channel = picture.alpha_channel();
  // Only floats have alpha multiplied into the colours, as OpenImageIO expects it.
  if (picture.type != PixelType::real) spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("oiio:ColorSpace", picture.is_srgb ? "sRGB" : "Linear");
  if (ending == ".jpg" || ending == ".jpeg") {
    spec.attribute("Compression", "jpeg:" + std::to_string(jpeg_quality));
    spec.attribute("jpeg:subsampling", "4:4:4");  // solids have sharp coloured edges
  } else {
    spec.attribute("Compression", "zip");
  }
  // Some kinds of files always hold a time, by default the present one: the same picture makes the same file.
  spec.attribute("DateTime", "1970:01:01 00:00:00");
  for (const auto& [name, text] : picture.notes) spec.attribute(name, text);
  return spec;
}

void write(OIIO::ImageOutput& output, const std::string& name, const EncodedPicture& picture,
           const OIIO::ImageSpec& spec) {
  if (!output.open(name, spec) || !output.write_image(type_of(picture.type), picture.pixels) || !output.close())
    throw std::runtime_error(output.geterror());
}

/// A file that goes away with it, for kinds of pictures that are not written to memory.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& ending) {
    const char* folder = std::getenv("TMPDIR");
    name_ = std::string(folder != nullptr ? folder : "/tmp") + "/csgcast-XXXXXX" + ending;
    const int file = ::mkstemps(name_.data(), static_cast<int>(ending.size()));
    if (file < 0) throw std::runtime_error("no temporary file can be made in " + name_);
    ::close(file);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { ::unlink(name_.c_str()); }

  const std::string& name() const { return name_; }
  std::vector<std::byte> bytes() const {
    std::ifstream stream(name_, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    const auto* first = reinterpret_cast<const std::byte*>(content.data());
    return {first, first + content.size()};
  }

 private:
  std::string name_;
};

/// WebP without loss: what OpenImageIO 2.4 calls so halves the resolution of colours. Notes have no place in it.
std::vector<std::byte> lossless_webp(const EncodedPicture& picture) {
  const auto* from = static_cast<const std::uint8_t*>(picture.pixels);
  const std::size_t pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  const std::size_t count = picture.channels.size();
  std::vector<std::uint8_t> rgba(4 * pixels, 255);
  for (std::size_t i = 0; i < pixels; ++i) {
    for (std::size_t c = 0; c < 3; ++c) rgba[4 * i + c] = from[count * i + (count >= 3 ? c : 0)];
    if (picture.alpha_channel() >= 0) rgba[4 * i + 3] = from[count * i + 3];
  }
  std::uint8_t* bytes = nullptr;
  const std::size_t size =
      WebPEncodeLosslessRGBA(rgba.data(), picture.width, picture.height, 4 * picture.width, &bytes);
  const std::unique_ptr<std::uint8_t, decltype(&WebPFree)> owner(bytes, WebPFree);
  if (size == 0) throw std::runtime_error("libwebp gave up");
  const auto* first = reinterpret_cast<const std::byte*>(bytes);
  return {first, first + size};
}

std::vector<std::byte> encode(const EncodedPicture& picture, const std::string& ending) {
  if (ending == ".webp") return lossless_webp(picture);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(ending.substr(1));
  if (!output) throw std::runtime_error(OIIO::geterror());
  if (picture.alpha_channel() >= 0 && output->supports("alpha") == 0)
    throw std::runtime_error("it has no transparency (alpha)");
  const OIIO::ImageSpec spec = spec_of(picture, ending);
  const std::string name = "picture" + ending;
  // TIFF files in memory come out broken (OpenImageIO 2.4).
  const bool is_tiff = ending == ".tif" || ending == ".tiff";
  if (is_tiff || output->supports("ioproxy") == 0) {
    const TemporaryFile file(ending);
    write(*output, file.name(), picture, spec);
    return file.bytes();
  }
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  if (!output->set_ioproxy(&memory)) throw std::runtime_error(output->geterror());
  write(*output, name, picture, spec);
  const auto* first = reinterpret_cast<const std::byte*>(bytes.data());
  return {first, first + bytes.size()};
}

DecodedPicture decode(const std::string& path, std::size_t most) {
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path);
  if (!input) throw std::runtime_error(OIIO::geterror());
  // Of icons that it wrote itself it writes beyond its memory (OpenImageIO 2.4).
  if (std::string_view(input->format_name()) == "ico") throw std::runtime_error("icons are not read");
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1) throw std::runtime_error("it is no flat picture");
  if (spec.image_pixels() * static_cast<OIIO::imagesize_t>(spec.nchannels) > most)
    throw std::runtime_error("it is too large");
  DecodedPicture picture{spec.width, spec.height, spec.channelnames, {}, static_cast<int>(8 * spec.format.size()),
                         false,      {}};
  // Radiance says "linear", others "Linear".
  const bool is_float = spec.format.is_floating_point();
  const std::string space = spec.get_string_attribute("oiio:ColorSpace", is_float ? "Linear" : "sRGB");
  picture.is_srgb = !OIIO::Strutil::iequals(space, "linear");
  for (const OIIO::ParamValue& note : spec.extra_attribs) picture.notes.emplace_back(note.name(), note.get_string());
  picture.values.resize(static_cast<std::size_t>(spec.image_pixels()) * static_cast<std::size_t>(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, picture.values.data()))
    throw std::runtime_error(input->geterror());
  return picture;
}

}  // namespace
}  // namespace csgcast::detail

extern "C" __attribute__((visibility("default"))) const csgcast::detail::PictureModule* csgcast_picture_module() {
  using namespace csgcast::detail;
  static const PictureModule module{module_version, encode, decode};
  return &module;
}
