// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "csg/base/vector.h"
#include "measure/sheet/linear_cut.h"
#include "raycast/cells/pieces.h"

namespace csgcast::detail {

/// The least and the greatest value of a quantity.
struct Range {
  double low = 0;
  double high = 0;

  double middle() const { return 0.5 * (low + high); }
  double half() const { return 0.5 * (high - low); }
};

/// The surfaces of a piece, about the middle of its box.
///
/// Two planes become one if they are nowhere in the box farther apart than their uncertainty, and if the value between
/// them is the value on one of their sides. For example, these are the halves of a square whose corners were rounded.
/// `slack` then covers both.
struct PieceForms {
  PieceForms(const Space& space, const Piece& piece);

  std::size_t count = 0;
  TruthTable table;  ///< as the table of a piece, but for these surfaces
  Vector middle;
  Vector half;
  std::array<LocalForm, Piece::most_surfaces> f{};
  std::array<bool, Piece::most_surfaces> is_plane{};
  std::array<std::uint32_t, Piece::most_surfaces> surface{};  ///< SurfaceId; for twins, the first one's
  bool are_known = true;                                      ///< true if all of them are known

  double volume() const { return 8 * half.x * half.y * half.z; }
  /// The range of the second-degree terms in the box.
  Range bend_of(const LocalForm& form) const;
  /// The range of the gradient's component along an axis, for the exact form.
  Range slope_of(const LocalForm& form, std::size_t axis) const;
  /// True if a point of the box, relative to its middle, is certainly inside.
  bool surely_hold(Vector d) const;

 private:
  void merge_twins();
  bool merge(std::size_t i, std::size_t j);
};

/// The value of a form at a place, relative to the middle of its box.
double value_at(const LocalForm& form, Vector d);

/// The coefficient of the product of two axes.
inline double bend_along(const LocalForm& form, std::size_t i, std::size_t j) {
  return form.bend[Moments::of_axes(i, j)];
}

}  // namespace csgcast::detail
