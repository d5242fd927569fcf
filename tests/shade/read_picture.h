// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace csgcast::test {

/// A picture file as its library reads it.
struct Picture {
  int width = 0;
  int height = 0;
  int bits = 0;                                            ///< a channel: 8, or 32 for floats
  bool is_srgb = false;                                    ///< by the module: the numbers are not linear
  std::vector<std::string> channels;                       ///< R, G, B in this order, or one
  std::vector<float> values;                               ///< rows from the top; 8 bits divided by 255
  std::vector<std::pair<std::string, std::string>> notes;  ///< but not of .png with 8 bits
};

/// .png with 8 bits by libpng, others by the module for pictures. Throws std::runtime_error on a file that cannot be
/// read.
Picture read_picture(const std::string& path);

}  // namespace csgcast::test
