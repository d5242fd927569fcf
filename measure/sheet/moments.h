// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "csg/base/vector.h"

namespace csgcast::detail {

/// The integrals of 1, x, y, z and of their products over a set.
struct Moments {
  double volume = 0;
  std::array<double, 3> first{};   ///< x, y, z
  std::array<double, 6> second{};  ///< xx, yy, zz, xy, xz, yz

  static constexpr std::array<std::array<std::size_t, 2>, 6> pair{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  /// The index in `second` of the product of two axes.
  static constexpr std::size_t of_axes(std::size_t i, std::size_t j) { return i == j ? i : i + j + 2; }

  Moments& operator+=(const Moments& other) {
    volume += other.volume;
    for (std::size_t i = 0; i < 3; ++i) first[i] += other.first[i];
    for (std::size_t i = 0; i < 6; ++i) second[i] += other.second[i];
    return *this;
  }
  friend Moments operator*(double s, Moments m) {
    m.volume *= s;
    for (double& x : m.first) x *= s;
    for (double& x : m.second) x *= s;
    return m;
  }
};

/// The moments of the same set, moved by an offset.
Moments moved(const Moments& moments, Vector by);

/// The moments of the box |d_i| <= half_i.
Moments box_moments(Vector half);

}  // namespace csgcast::detail
