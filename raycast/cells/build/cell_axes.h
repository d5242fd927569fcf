// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "csg/base/length.h"
#include "csg/base/vector.h"
#include "raycast/scene/scene.h"
#include "raycast/surface/form_range.h"

namespace csgcast::detail {

/// Three unit directions in the frame, square to each other to 2^-60, along which a scene's faces lie. In these axes
/// the sides of turned boxes are square to the axes again.
struct CellAxes {
  using Row = std::array<long double, 3>;

  std::array<Row, 3> rows{};

  /// The rows as doubles.
  std::array<Vector, 3> rounded() const;
  /// A surface's form in these axes. Turning and rounding change each coefficient by less than 2^-58 of the sum of all.
  /// The result's `off` bounds the change of the form within a distance of 2 from the form's center.
  CellForm turned(const CellForm& form) const;
  Vector turned(Vector v) const;
  /// The box in these axes that holds a box of the frame. If that box has an infinite side, the result is all of space.
  /// If that box is empty, the result is empty: its lower sides are above the upper ones.
  CellBox holding(const CellBox& box) const;
  /// The box of the frame that holds a box in these axes, with the same rules.
  CellBox turned_back(const CellBox& box) const;
};

/// The directions that most planes of a bounded scene are square to. Returns nothing if these are the frame's own axes,
/// or if too few planes share a direction.
std::optional<CellAxes> common_axes(const Scene& scene);

/// True if a box is near enough to the frame for forms to be turned (CellAxes::turned). It is false only for solids
/// that half-spaces bound far beyond every bounded leaf.
inline bool near_frame(const CellBox& box) { return longest(box.lower) <= 1 && longest(box.upper) <= 1; }

}  // namespace csgcast::detail
