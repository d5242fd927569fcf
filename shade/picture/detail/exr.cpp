// SPDX-License-Identifier: MIT
#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cstring>

#include "shade/picture/detail/picture_formats.h"

namespace csgcast::detail {
namespace {

class MemoryStream : public Imf::OStream {
 public:
  explicit MemoryStream(std::vector<std::byte>& bytes) : OStream("picture"), bytes_(bytes) {}

  void write(const char data[], int size) override {
    const std::size_t count = static_cast<std::size_t>(size);
    bytes_.resize(std::max(bytes_.size(), position_ + count));
    if (count > 0) std::memcpy(bytes_.data() + position_, data, count);
    position_ += count;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

 private:
  std::vector<std::byte>& bytes_;
  std::size_t position_ = 0;
};

// Its channels, in the order the film has them.
std::vector<const char*> names_of(FilmContent content) {
  if (channels(content) == 3) return {"R", "G", "B"};
  return {content == FilmContent::depth ? "Z" : "Y"};
}

}  // namespace

std::vector<std::byte> exr_file(const Film& film) {
  const std::vector<const char*> names = names_of(film.content());
  const std::size_t pixel_size = names.size() * sizeof(float);
  Imf::Header header(film.width(), film.height());
  header.compression() = Imf::ZIP_COMPRESSION;
  header.insert("Software", Imf::StringAttribute("csgcast"));
  Imf::FrameBuffer frame;
  for (std::size_t i = 0; i < names.size(); ++i) {
    header.channels().insert(names[i], Imf::Channel(Imf::FLOAT));
    auto* first = reinterpret_cast<char*>(const_cast<float*>(film.values().data() + i));  // it is only read
    frame.insert(names[i],
                 Imf::Slice(Imf::FLOAT, first, pixel_size, pixel_size * static_cast<std::size_t>(film.width())));
  }
  std::vector<std::byte> bytes;
  try {
    MemoryStream stream(bytes);
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frame);
    file.writePixels(film.height());
  } catch (const Iex::BaseExc& problem) {
    throw PictureFailure(problem.what());
  }
  return bytes;
}

}  // namespace csgcast::detail
