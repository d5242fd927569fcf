// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "csg/base/vector.h"
#include "raycast/cells/formula/form_range.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// Three directions in the frame along which a scene's faces lie, unit and square to each other to 2^-60: in these
/// axes boxes are boxes again.
struct CellAxes {
  using Row = std::array<long double, 3>;

  std::array<Row, 3> rows{};

  std::array<Vector, 3> rounded() const;
  /// A surface's form in these axes: each coefficient rounded, of what is off by less than 2^-58 of all.
  CellForm turned(const CellForm& form) const;
  Vector turned(Vector v) const;
  /// The box in these axes that holds a box; all of space if that has an infinite side, nothing if it holds nothing.
  CellBox holding(const CellBox& box) const;
};

/// The directions that most planes of a bounded scene are square to; none if that are the frame's own axes, or hardly
/// any plane has another's direction.
std::optional<CellAxes> common_axes(const Scene& scene);

}  // namespace csgcast::detail
