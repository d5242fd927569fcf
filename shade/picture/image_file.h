// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "shade/film/film.h"

namespace csgcast {

/// Throws Error(usage), with the list of known endings, unless the path ends in .png, .jpg, .jpeg, .tif, .tiff or .exr
/// (either case).
void check_image_path(const std::string& path);

/// The content of a film's file, of the kind that the path's ending tells: 8 bits a channel for .png, .jpg and .tif
/// (see FilmContent for what they hold), the film's own numbers as 32-bit floats for .exr (channels R, G, B, or Z for
/// depth, else Y).
///
/// Throws as check_image_path() does; Error(limit) for a picture that is too large for that kind; Error(machine) if its
/// library fails.
std::vector<std::byte> image_bytes(const Film& film, const std::string& path);

/// Writes that as a WholeFile. Throws as image_bytes() and WholeFile do.
void write_image(const Film& film, const std::string& path);

}  // namespace csgcast
