// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shade/film/tile.h"

namespace csgcast::detail {

/// Samples to trace at once: where in the picture they are, and where their colours belong.
struct Samples {
  std::vector<double> x, y;
  std::vector<std::uint32_t> place;
  std::vector<double> column_x;  ///< of the rectangle that is appended

  void clear() {
    x.clear();
    y.clear();
    place.clear();
  }
};

/// Appends the samples of a rectangle of them, in a picture of k x k samples a pixel: four by two at a time, so that
/// those of a packet are neighbours. place(column, row) says where the colour of each belongs.
template <class Place>
void append(const Tile& rectangle, int k, Samples& samples, Place&& place) {
  const auto room =
      static_cast<std::size_t>(rectangle.x1 - rectangle.x0) * static_cast<std::size_t>(rectangle.y1 - rectangle.y0);
  std::size_t count = samples.x.size();
  samples.x.resize(count + room);
  samples.y.resize(count + room);
  samples.place.resize(count + room);
  samples.column_x.clear();
  for (int x = rectangle.x0; x < rectangle.x1; ++x) samples.column_x.push_back((x + 0.5) / k);
  for (int row = rectangle.y0; row < rectangle.y1; row += 2) {
    const double row_y[2] = {(row + 0.5) / k, (row + 1.5) / k};
    for (int column = rectangle.x0; column < rectangle.x1; column += 4) {
      for (int y = row; y < std::min(row + 2, rectangle.y1); ++y) {
        for (int x = column; x < std::min(column + 4, rectangle.x1); ++x) {
          samples.x[count] = samples.column_x[static_cast<std::size_t>(x - rectangle.x0)];
          samples.y[count] = row_y[y - row];
          samples.place[count++] = static_cast<std::uint32_t>(place(x, y));
        }
      }
    }
  }
}

}  // namespace csgcast::detail
