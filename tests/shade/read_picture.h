// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace csgcast::test {

/// A picture file as its library reads it.
struct Picture {
  int width = 0;
  int height = 0;
  int bits = 0;                       ///< a channel: 8, or 32 for floats
  std::vector<std::string> channels;  ///< R, G, B in this order, or one
  std::vector<float> values;          ///< rows from the top; 8 bits divided by 255
};

/// By its ending: .png, .jpg, .tif or .exr. Throws std::runtime_error on a file that cannot be read.
Picture read_picture(const std::string& path);

}  // namespace csgcast::test
