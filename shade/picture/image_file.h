// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shade/film/film.h"

namespace csgcast {

struct PictureOptions {
  int bits = 0;  ///< a channel: 8, 16, or 32 for floats; 0: what is usual for the kind of file
  /// What the file says of itself besides "Software", as names and texts: kinds of files without room for it drop it.
  std::vector<std::pair<std::string, std::string>> notes{};
  /// What the picture will show: check_image_path() asks whether the kind of file holds it. Files are of the film's
  /// own.
  FilmContent content = FilmContent::color;
};

/// Throws Error(usage) unless the path ends in a kind of picture that can be written, in either case, with so many
/// bits and such content; the error lists what can. Begins to load what will write it, on a thread of its own: call it
/// early.
void check_image_path(const std::string& path, const PictureOptions& options = {});

/// The content of a film's file, of the kind that the path's ending tells. With 8 and 16 bits a channel numbers are
/// those of FilmContent; alpha is then not multiplied into the colours. With 32 bits they are the film's own.
///
/// .png with 8 bits is written by libpng, all else by OpenImageIO, in a module that is loaded when it is needed.
///
/// Throws as check_image_path() does; Error(limit) for a picture that is too large for that kind; Error(unsupported) if
/// the module is missing, and for what the kind of file cannot hold; Error(machine) if its library fails.
std::vector<std::byte> image_bytes(const Film& film, const std::string& path, const PictureOptions& options = {});

/// Writes that as a WholeFile. Throws as image_bytes() and WholeFile do.
void write_image(const Film& film, const std::string& path, const PictureOptions& options = {});

/// Some channels of a file that has many.
struct NamedChannels {
  const Film* film;
  std::vector<std::string> channels;  ///< as many names as the film has channels
};

/// True if files of this kind hold any channels by name (.exr).
bool holds_layers(const std::string& path);

/// The content of a file with all channels of the layers, as 32-bit floats. The films have one size. Throws as
/// image_bytes() does, and Error(usage) for a kind of file that does not hold them.
std::vector<std::byte> layer_bytes(std::span<const NamedChannels> layers, const std::string& path,
                                   const PictureOptions& options = {});

}  // namespace csgcast
