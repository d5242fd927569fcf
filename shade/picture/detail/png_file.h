// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "shade/picture/detail/encode.h"

namespace csgcast::detail {

using PictureNotes = std::vector<std::pair<std::string, std::string>>;

/// The whole .png of a picture with 8 bits a channel: the same bytes for the same picture, without a date. It is
/// written here, by libpng, because most pictures are .png and the module for the other kinds takes 0.2 s to load.
/// `notes`: keywords of ASCII, and texts of UTF-8. Throws std::runtime_error with what libpng says.
std::vector<std::byte> png_file(const EncodedFilm& picture, const PictureNotes& notes);

}  // namespace csgcast::detail
