// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "csg/base/place.h"

namespace csgcast::detail {

/// What a channel's numbers are: 8 or 16 bits without a sign, or 32-bit floats.
enum class PixelType : std::uint8_t { byte, word, real };

/// A picture to write: rows from the top, the channels of a pixel next to each other.
struct EncodedPicture {
  int width = 0;
  int height = 0;
  PixelType type = PixelType::byte;
  std::vector<std::string> channels{};  ///< their names: R, G, B; Y alone; then maybe A
  const void* pixels = nullptr;
  bool is_srgb = false;  ///< the numbers are sRGB, not linear
  std::vector<std::pair<std::string, std::string>> notes{};

  /// -1: none.
  int alpha_channel() const {
    const auto found = std::find(channels.begin(), channels.end(), "A");
    return found == channels.end() ? -1 : static_cast<int>(found - channels.begin());
  }
};

/// A picture that was read, as floats: rows from the top, the channels of a pixel next to each other.
struct DecodedPicture {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;
  std::vector<float> values;
  int bits = 0;          ///< a channel, in the file
  bool is_srgb = false;  ///< the numbers are sRGB: 8 or 16 bits a channel that do not say otherwise
  std::vector<std::pair<std::string, std::string>> notes;
};

/// What the module for pictures does. It alone knows OpenImageIO, whose 260 libraries take 0.2 s to load: programs load
/// the module when they need it. Both functions throw std::runtime_error with what went wrong.
struct PictureModule {
  const char* version;  ///< module_version.h, as it was made
  /// The bytes of a whole file. `ending`: lower case, with its dot.
  std::vector<std::byte> (*encode)(const EncodedPicture& picture, const std::string& ending);
  /// Reads a file of any kind. `most`: more numbers than this are refused.
  DecodedPicture (*decode)(const std::string& path, std::size_t most);
};

/// The function that the module exports: extern "C" const PictureModule* csgcast_picture_module().
constexpr const char* module_entry = "csgcast_picture_module";

/// The module, loaded at the first call. Throws Error(unsupported) if it cannot be loaded, at the place that needs it;
/// `otherwise` is what one can do without. It is looked for in the folder that the environment variable CSGCAST_MODULES
/// names; without the variable where the program's run path says, then in the folder that it is installed into.
const PictureModule& picture_module(const Place& place, const std::string& otherwise = "write a .png");

/// Begins to load it on a thread of its own, so that picture_module() waits less. What goes wrong, that tells.
void prepare_picture_module();

}  // namespace csgcast::detail
