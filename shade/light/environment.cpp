// SPDX-License-Identifier: MIT
#include "shade/light/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "csg/base/precondition.h"

namespace csgcast {

Environment::Environment(int width, int height, std::vector<float> rgb)
    : width_(width), height_(height), rgb_(std::move(rgb)) {
  CSGCAST_PRECONDITION(width > 0 && height > 0 && rgb_.size() == 3 * std::size_t(width) * std::size_t(height));
}

Rgb Environment::pixel(int x, int y) const {
  const int column = (x % width_ + width_) % width_;
  const int row = std::clamp(y, 0, height_ - 1);
  const std::size_t at =
      3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column));
  return {rgb_[at], rgb_[at + 1], rgb_[at + 2]};
}

Rgb Environment::color(Vector direction) const {
  const double east = std::atan2(direction.x, direction.y) / (2 * std::numbers::pi);  // of +y, -1/2 to 1/2
  const double across = std::hypot(direction.x, direction.y);
  const double down = std::atan2(across, direction.z) / std::numbers::pi;  // 0 at +z, 1 at -z
  // Colours stand in the middles of pixels.
  const double x = (east + 0.5) * width_ - 0.5;
  const double y = down * height_ - 0.5;
  const double left = std::floor(x);
  const double top = std::floor(y);
  const double right_share = x - left;
  const double lower_share = y - top;
  const int column = static_cast<int>(left);
  const int row = static_cast<int>(top);
  const auto between = [&](int at_row) {
    return (1 - right_share) * pixel(column, at_row) + right_share * pixel(column + 1, at_row);
  };
  return (1 - lower_share) * between(row) + lower_share * between(row + 1);
}

}  // namespace csgcast
