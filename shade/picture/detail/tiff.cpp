// SPDX-License-Identifier: MIT
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <string>

#include "shade/picture/detail/picture_formats.h"

namespace csgcast::detail {
namespace {

constexpr int rows_per_strip = 32;

// A file in memory, with libtiff's idea of one.
struct Target {
  std::vector<std::byte> bytes;
  std::size_t position = 0;
  std::array<char, 256> problem{};
};

Target& target_of(thandle_t handle) { return *static_cast<Target*>(handle); }

tmsize_t read(thandle_t handle, void* data, tmsize_t size) {
  Target& target = target_of(handle);
  const std::size_t left = target.bytes.size() - std::min(target.position, target.bytes.size());
  const std::size_t count = std::min(static_cast<std::size_t>(size), left);
  if (count > 0) std::memcpy(data, target.bytes.data() + target.position, count);
  target.position += count;
  return static_cast<tmsize_t>(count);
}

tmsize_t write(thandle_t handle, void* data, tmsize_t size) {
  Target& target = target_of(handle);
  const std::size_t end = target.position + static_cast<std::size_t>(size);
  try {  // no exception may pass through libtiff
    if (end > target.bytes.size()) target.bytes.resize(end);
  } catch (const std::bad_alloc&) {
    return 0;
  }
  if (size > 0) std::memcpy(target.bytes.data() + target.position, data, static_cast<std::size_t>(size));
  target.position = end;
  return size;
}

toff_t seek(thandle_t handle, toff_t offset, int whence) {
  Target& target = target_of(handle);
  const std::size_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? target.position : target.bytes.size();
  return target.position = from + offset;  // unsigned: a step back wraps round as it should
}

toff_t size_of(thandle_t handle) { return target_of(handle).bytes.size(); }

int close(thandle_t /*handle*/) { return 0; }

int note_error(TIFF* /*tiff*/, void* target, const char* /*module*/, const char* format, std::va_list arguments) {
  std::array<char, 256>& problem = static_cast<Target*>(target)->problem;
  std::vsnprintf(problem.data(), problem.size(), format, arguments);
  return 1;
}

int ignore_warning(TIFF* /*tiff*/, void* /*target*/, const char* /*module*/, const char* /*format*/,
                   std::va_list /*arguments*/) {
  return 1;
}

// Errors go to the target: libtiff's own handlers are global and print.
TIFF* open(Target& target) {
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                 TIFFOpenOptionsFree);
  if (!options) return nullptr;
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), note_error, &target);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_warning, &target);
  return TIFFClientOpenExt("picture", "wl", &target, read, write, seek, close, size_of, nullptr, nullptr,
                           options.get());
}

void write_head(TIFF* tiff, const EncodedFilm& picture) {
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(picture.width));
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(picture.height));
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, picture.channels);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, picture.channels == 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
  TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, static_cast<std::uint32_t>(rows_per_strip));
  TIFFSetField(tiff, TIFFTAG_SOFTWARE, "csgcast");
}

bool write_picture(TIFF* tiff, const EncodedFilm& picture) {
  write_head(tiff, picture);
  const std::size_t stride = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.channels);
  for (int y = 0; y < picture.height; y += rows_per_strip) {
    const int rows = std::min(rows_per_strip, picture.height - y);
    auto* first = const_cast<std::uint8_t*>(picture.bytes.data() + stride * static_cast<std::size_t>(y));  // only read
    const tmsize_t size = static_cast<tmsize_t>(stride) * rows;
    if (TIFFWriteEncodedStrip(tiff, static_cast<std::uint32_t>(y / rows_per_strip), first, size) != size) return false;
  }
  return TIFFWriteDirectory(tiff) != 0;
}

}  // namespace

std::vector<std::byte> tiff_file(const EncodedFilm& picture) {
  Target target;
  TIFF* tiff = open(target);
  const bool written = tiff != nullptr && write_picture(tiff, picture);
  if (tiff != nullptr) TIFFClose(tiff);
  const std::string problem = target.problem.data();
  if (!written || !problem.empty()) throw PictureFailure(problem.empty() ? "out of memory" : problem);
  return std::move(target.bytes);
}

}  // namespace csgcast::detail
