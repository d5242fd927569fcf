// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

#include "csg/base/vector.h"
#include "raycast/surface/cell_form.h"

namespace csgcast::detail {

/// The surfaces that cross a cell are determined for a box that is wider than the cell by this margin, in units of the
/// frame. Rounding moves an event along a ray by at most twice `greatest_slack`, at a speed below 2 on each axis, and
/// it moves coordinates by less than 2^-48. The margin is far more than both.
constexpr double cell_margin = 0x1p-28;

/// A split that passes by a face keeps this distance from it. This is more than the widening of cells and of the boxes
/// of leaves, so the face is seen on one side of the split only.
constexpr double face_clearance = 0x1p-26;

/// The box with all sides moved outward by a distance.
inline CellBox grown(const CellBox& box, double distance) {
  const Vector more{distance, distance, distance};
  return {box.lower - more, box.upper + more};
}

/// A cell's box, widened by the margin.
inline CellBox inflated(const CellBox& box) { return grown(box, cell_margin); }

/// True if the two boxes share no point. Boxes that touch share one.
inline bool apart(const CellBox& a, const CellBox& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a.lower[axis] > b.upper[axis] || a.upper[axis] < b.lower[axis]) return true;
  }
  return false;
}

/// The intersection of two boxes. If they are apart, a lower side of the result is above the upper one.
inline CellBox intersection(const CellBox& a, const CellBox& b) {
  CellBox result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.lower[axis] = std::fmax(a.lower[axis], b.lower[axis]);
    result.upper[axis] = std::fmin(a.upper[axis], b.upper[axis]);
  }
  return result;
}

/// The smallest box that holds both boxes.
inline CellBox hull(const CellBox& a, const CellBox& b) {
  CellBox result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.lower[axis] = std::fmin(a.lower[axis], b.lower[axis]);
    result.upper[axis] = std::fmax(a.upper[axis], b.upper[axis]);
  }
  return result;
}

/// Half the area of a box's surface.
inline double area(const CellBox& box) {
  const Vector s = box.upper - box.lower;
  return s.x * s.y + s.y * s.z + s.z * s.x;
}

/// The part of a box below a place on an axis. Precondition of this and of `above`: the place is within the box.
inline CellBox below(CellBox box, std::size_t axis, double at) {
  box.upper[axis] = at;
  return box;
}

/// The part of a box above a place on an axis.
inline CellBox above(CellBox box, std::size_t axis, double at) {
  box.lower[axis] = at;
  return box;
}

}  // namespace csgcast::detail
