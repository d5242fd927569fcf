// SPDX-License-Identifier: MIT
#include "shade/film/pixel_region.h"

#include <cstdint>
#include <string>

#include "csg/base/error.h"

namespace csgcast {

PixelRegion band_of_picture(int width, int height, int index, int count) {
  const std::string tile = "tile " + std::to_string(index) + "/" + std::to_string(count);
  if (count < 1 || index < 0 || index >= count) {
    throw Error(ErrorCode::usage, {}, tile + " does not exist", "tiles count from 0 to one less than their number",
                "give a number in that range");
  }
  if (count > height) {
    throw Error(ErrorCode::usage, {}, tile + " of a picture of " + std::to_string(height) + " rows",
                "a tile has a row at least", "ask for fewer tiles");
  }
  const auto row = [&](std::int64_t i) { return static_cast<int>(i * height / count); };
  return {0, row(index), width, row(std::int64_t{index} + 1)};
}

}  // namespace csgcast
