// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "csg/vector.h"
#include "measure/detail/linear_cut.h"
#include "raycast/pieces.h"

namespace csgcast::detail {

/// The least and the greatest value of something.
struct Range {
  double low = 0;
  double high = 0;

  double middle() const { return 0.5 * (low + high); }
  double half() const { return 0.5 * (high - low); }
};

/// The surfaces of a piece about the middle of its box.
struct PieceForms {
  PieceForms(const Space& space, const Piece& piece);

  std::size_t count = 0;
  Vector middle;
  Vector half;
  std::array<LocalForm, Piece::most_surfaces> f{};
  std::array<bool, Piece::most_surfaces> is_plane{};
  bool are_known = true;  ///< all of them

  double volume() const { return 8 * half.x * half.y * half.z; }
  /// What the second-degree terms come to in the box.
  Range bend_of(const LocalForm& form) const;
  /// Of the part of a gradient along an axis.
  Range slope_of(const LocalForm& form, std::size_t axis) const;
};

/// The coefficient of the product of two axes.
inline double bend_along(const LocalForm& form, std::size_t i, std::size_t j) {
  return form.bend[Moments::of_axes(i, j)];
}

}  // namespace csgcast::detail
