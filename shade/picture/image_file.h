// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "shade/film/film.h"

namespace csgcast {

/// Throws Error(usage), with the list of known endings, unless the path ends in .png, .jpg, .jpeg, .tif, .tiff or .exr
/// (either case).
void check_image_path(const std::string& path);

/// Writes a film: 8 bits a channel for .png, .jpg and .tif (see FilmContent for what they hold), the film's own numbers
/// as 32-bit floats for .exr (channels R, G, B, or Z for depth, else Y).
///
/// The file appears whole: it is written beside its target, then renamed. On failure an existing file is left as it
/// was, nothing is left behind, and Error(input_output) tells why. Throws as check_image_path() does, before anything
/// else.
void write_image(const Film& film, const std::string& path);

}  // namespace csgcast
