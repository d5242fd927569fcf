// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "shade/film/film.h"
#include "shade/picture/detail/encode.h"

namespace csgcast::detail {

/// What the library of a kind of picture says when it gives up.
struct PictureFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The whole file of a picture: the same bytes for the same picture, without a date. Each is made in one file, the only
/// one that knows the library that does it: libpng, libjpeg, libtiff, OpenEXR. They are linked directly because a
/// program starts with all its libraries: these four load in two milliseconds, where one that reads every kind of
/// picture (OpenImageIO, with 250 libraries behind it) took 160. Throws PictureFailure.
std::vector<std::byte> png_file(const EncodedFilm& picture);
std::vector<std::byte> jpeg_file(const EncodedFilm& picture);
std::vector<std::byte> tiff_file(const EncodedFilm& picture);
std::vector<std::byte> exr_file(const Film& film);

}  // namespace csgcast::detail
