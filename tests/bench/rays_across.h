// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <vector>

#include "csg/base/box.h"
#include "csg/base/length.h"
#include "raycast/line/ray.h"

namespace csgcast::bench {

/// side x side parallel rays along `direction` (unit), from outside the box, spread over a square as wide as the box's
/// diagonal.
inline std::vector<Ray> rays_across(const Box& box, Vector direction, int side) {
  const double diagonal = length(box.size());
  const Vector aside = std::fabs(direction.z) < 0.9 ? Vector{0, 0, 1} : Vector{0, 1, 0};
  const Vector right = normalised(cross(direction, aside));
  const Vector up = cross(right, direction);
  const Point corner = box.center() - diagonal * direction - (diagonal / 2) * (right + up);
  std::vector<Ray> rays;
  rays.reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double step = diagonal / side;
      rays.emplace_back(corner + step * ((column + 0.5) * right + (row + 0.5) * up), direction);
    }
  }
  return rays;
}

}  // namespace csgcast::bench
