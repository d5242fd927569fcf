// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "csg/base/box.h"
#include "csg/base/progress.h"
#include "csg/base/vector.h"

namespace csgcast {

/// A number, and a bound on how far the true value is from it: proved, rounding included (docs/measuring.md).
struct Measured {
  double value = 0;
  double error = 0;
};

/// What a body comes to. Lengths are in the scene's unit; masses are densities times volumes.
///
/// An empty solid has zeros, and a centroid that is not a number. Of a solid that may be unbounded nothing is measured:
/// numbers are infinite, or are none.
struct Measures {
  bool is_bounded = true;
  Measured volume;
  Measured area;  ///< of the boundary of the regularised solid: where solids touch there is none
  Measured mass;
  Point centroid{};                 ///< the centre of mass
  double centroid_error = 0;        ///< of each coordinate
  std::array<double, 6> inertia{};  ///< the tensor about the centroid, along the scene's axes: xx, yy, zz, xy, xz, yz
  double inertia_error = 0;         ///< of each entry
  Box bounds;                       ///< holds the solid; null if that is empty
  double bounds_error = 0;          ///< it is nowhere farther from a side than this
  std::size_t pieces = 0;           ///< that space was cut into
  bool is_as_asked = true;          ///< the errors of volume and area are as small as asked for
};

struct MeasureOptions {
  double relative_error = 1e-4;       ///< of volumes, error / value
  double relative_area_error = 1e-3;  ///< of areas, which take more pieces; infinite: any
  /// The greatest number of pieces of a body, some 500 bytes each; then the bounds are what they are.
  std::size_t most_pieces = 4'000'000;
  /// Asked now and then with a volume's present relative error; true: the bounds that are known by then are the result,
  /// and Measures::is_as_asked tells if they are as small as asked for. Never asked by two threads at once. May be
  /// empty.
  std::function<bool(double relative_error)> is_enough{};
  /// To cancel is another thing: then there is no result.
  ProgressCallback progress{};
};

}  // namespace csgcast
