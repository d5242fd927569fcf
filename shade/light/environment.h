// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "csg/base/vector.h"
#include "csg/solid/look.h"

namespace csgcast {

/// What is seen in each direction beyond the solid: a picture of the whole sphere by longitude and latitude. Its upper
/// edge is +z, its lower edge -z, its middle +y; east, +x, is a quarter to the right of that.
class Environment {
 public:
  /// `rgb`: linear, three numbers a pixel, rows from the top. Precondition: 3 width height numbers, at least one pixel.
  Environment(int width, int height, std::vector<float> rgb);

  /// Between the four pixels around the direction, which is not zero; without a seam where left and right edge meet.
  Rgb color(Vector direction) const;

 private:
  Rgb pixel(int x, int y) const;

  int width_;
  int height_;
  std::vector<float> rgb_;
};

}  // namespace csgcast
