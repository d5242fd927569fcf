// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "csg/base/vector.h"
#include "measure/sheet/linear_cut.h"
#include "raycast/cells/pieces.h"

namespace csgcast::detail {

/// The least and the greatest value of something.
struct Range {
  double low = 0;
  double high = 0;

  double middle() const { return 0.5 * (low + high); }
  double half() const { return 0.5 * (high - low); }
};

/// The surfaces of a piece about the middle of its box.
///
/// Planes that are nowhere in the box farther apart than they are certain, such as the halves of a square whose corners
/// were rounded, are one, if the value between them is that on one of their sides: `slack` then covers them all.
struct PieceForms {
  PieceForms(const Space& space, const Piece& piece);

  std::size_t count = 0;
  TruthTable table;  ///< as of a piece, over these
  Vector middle;
  Vector half;
  std::array<LocalForm, Piece::most_surfaces> f{};
  std::array<bool, Piece::most_surfaces> is_plane{};
  std::array<std::uint32_t, Piece::most_surfaces> surface{};  ///< SurfaceId, of twins the first
  bool are_known = true;                                      ///< all of them

  double volume() const { return 8 * half.x * half.y * half.z; }
  /// What the second-degree terms come to in the box.
  Range bend_of(const LocalForm& form) const;
  /// Of the part of a gradient along an axis, of the exact form.
  Range slope_of(const LocalForm& form, std::size_t axis) const;
  /// Whether a point of the box, from its middle, is inside for sure.
  bool surely_hold(Vector d) const;

 private:
  void merge_twins();
  bool merge(std::size_t i, std::size_t j);
};

/// A form at a place, from the middle of its box.
double value_at(const LocalForm& form, Vector d);

/// The coefficient of the product of two axes.
inline double bend_along(const LocalForm& form, std::size_t i, std::size_t j) {
  return form.bend[Moments::of_axes(i, j)];
}

}  // namespace csgcast::detail
