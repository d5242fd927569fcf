// SPDX-License-Identifier: MIT
#pragma once

namespace csgcast {

/// A rectangle of pixels of a picture: columns [x0, x1) and rows [y0, y1), from the top left.
struct PixelRegion {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
  friend bool operator==(const PixelRegion&, const PixelRegion&) = default;

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
};

/// Band `index` of the `count` bands of whole rows that a picture is cut into, from the top; their heights differ by
/// one row at most. Throws Error(usage) unless 0 <= index < count <= height.
PixelRegion band_of_picture(int width, int height, int index, int count);

}  // namespace csgcast
