// SPDX-License-Identifier: MIT
// jpeglib.h needs <cstdio> before it:
// clang-format off
#include <cstdio>
#include <jpeglib.h>
// clang-format on

#include <array>
#include <csetjmp>
#include <cstdlib>
#include <string>
#include <string_view>

#include "shade/picture/detail/picture_formats.h"

namespace csgcast::detail {
namespace {

constexpr int quality = 98;  // edges show no ripples yet
constexpr std::string_view software = "csgcast";

// What libjpeg's callbacks find through its pointer to the first member.
struct ErrorManager {
  jpeg_error_mgr base;
  std::jmp_buf escape;
  std::array<char, JMSG_LENGTH_MAX> problem;
};

[[noreturn]] void fail(j_common_ptr jpeg) {
  auto* manager = reinterpret_cast<ErrorManager*>(jpeg->err);
  manager->base.format_message(jpeg, manager->problem.data());
  std::longjmp(manager->escape, 1);
}

void ignore_message(j_common_ptr /*jpeg*/) {}

class Writer {
 public:
  Writer() {
    jpeg_.err = jpeg_std_error(&errors_.base);
    errors_.base.error_exit = fail;
    errors_.base.output_message = ignore_message;
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() {
    jpeg_destroy_compress(&jpeg_);
    std::free(data_);
  }

  /// False if libjpeg gave up. It then jumps back to here, over frames that have nothing to destroy.
  bool write(const EncodedFilm& picture) {
    if (setjmp(errors_.escape) != 0) return false;
    jpeg_create_compress(&jpeg_);
    jpeg_mem_dest(&jpeg_, &data_, &size_);
    write_head(picture);
    const std::size_t stride = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.channels);
    while (jpeg_.next_scanline < jpeg_.image_height) {
      auto* row = const_cast<JSAMPLE*>(picture.bytes.data() + stride * jpeg_.next_scanline);  // it is only read
      jpeg_write_scanlines(&jpeg_, &row, 1);
    }
    jpeg_finish_compress(&jpeg_);
    return true;
  }

  const char* problem() const { return errors_.problem.data(); }
  std::vector<std::byte> bytes() const {
    const auto* first = reinterpret_cast<const std::byte*>(data_);
    return {first, first + size_};
  }

 private:
  void write_head(const EncodedFilm& picture) {
    jpeg_.image_width = static_cast<JDIMENSION>(picture.width);
    jpeg_.image_height = static_cast<JDIMENSION>(picture.height);
    jpeg_.input_components = picture.channels;
    jpeg_.in_color_space = picture.channels == 3 ? JCS_RGB : JCS_GRAYSCALE;
    jpeg_set_defaults(&jpeg_);
    jpeg_set_quality(&jpeg_, quality, TRUE);
    // Colour in full resolution: solids have sharp coloured edges.
    jpeg_.comp_info[0].h_samp_factor = 1;
    jpeg_.comp_info[0].v_samp_factor = 1;
    jpeg_start_compress(&jpeg_, TRUE);
    jpeg_write_marker(&jpeg_, JPEG_COM, reinterpret_cast<const JOCTET*>(software.data()),
                      static_cast<unsigned>(software.size()));
  }

  jpeg_compress_struct jpeg_{};
  ErrorManager errors_{};
  unsigned char* data_ = nullptr;
  unsigned long size_ = 0;
};

}  // namespace

std::vector<std::byte> jpeg_file(const EncodedFilm& picture) {
  Writer writer;
  if (!writer.write(picture)) throw PictureFailure(writer.problem());
  return writer.bytes();
}

}  // namespace csgcast::detail
