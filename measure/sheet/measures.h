// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "csg/base/box.h"
#include "csg/base/progress.h"
#include "csg/base/vector.h"

namespace csgcast {

/// A number and a proved bound on its error. The bound includes rounding (docs/measuring.md).
struct Measured {
  double value = 0;
  double error = 0;
};

/// The measures of a body. Lengths are in the scene's unit. Masses are densities times volumes.
///
/// For an empty solid all numbers are 0, and the centroid is NaN. A solid that may be unbounded is not measured: its
/// numbers are infinite or NaN.
struct Measures {
  bool is_bounded = true;
  Measured volume;
  Measured area;  ///< of the boundary of the regularised solid: where solids touch there is none
  Measured mass;
  Point centroid{};                 ///< the centre of mass
  double centroid_error = 0;        ///< of each coordinate
  std::array<double, 6> inertia{};  ///< the tensor about the centroid, along the scene's axes: xx, yy, zz, xy, xz, yz
  double inertia_error = 0;         ///< of each entry
  std::array<double, 3> principal_moments{};  ///< the tensor's eigenvalues, ascending
  double principal_error = 0;                 ///< of each
  std::array<Vector, 3> principal_axes{};     ///< unit, one for each moment, right-handed
  /// Of each axis: radians to the true one, as lines. Infinite: undetermined, as moments come too near each other.
  std::array<double, 3> principal_angles{};
  Box bounds;               ///< holds the solid; null if that is empty
  double bounds_error = 0;  ///< it is nowhere farther from a side than this
  std::size_t pieces = 0;   ///< that space was cut into
  bool is_as_asked = true;  ///< the errors of volume and area are as small as asked for
};

struct MeasureOptions {
  double relative_error = 1e-4;       ///< for volumes: error / value
  double relative_area_error = 1e-3;  ///< for areas, which need more pieces; infinite: any error will do
  /// The greatest number of pieces of a body, some 500 bytes each. If it is reached, the bounds stay as they are.
  std::size_t most_pieces = 4'000'000;
  /// Called now and then with a volume's present relative error. If it returns true, the bounds known by then are the
  /// result, and Measures::is_as_asked tells if they are as small as asked for. Two threads never call it at once. It
  /// may be empty.
  std::function<bool(double relative_error)> is_enough{};
  /// Cancelling is different: then there is no result.
  ProgressCallback progress{};
};

}  // namespace csgcast
