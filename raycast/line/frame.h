// SPDX-License-Identifier: MIT
#pragma once

#include "csg/base/box.h"
#include "csg/base/vector.h"

namespace csgcast {

/// The coordinates in which floating point works: q = (p - center) 2^-exponent.
///
/// Every bounded leaf of the scene lies within |q| < 1/2 on each axis. So error bounds do not depend on the scene's
/// place or unit, and nothing over- or underflows.
struct Frame {
  Point center;
  int exponent = 0;

  /// The frame of a scene whose bounded leaves fill a box. If the box is null or infinite, the frame is the world's own
  /// coordinates.
  static Frame around(const Box& bounded_leaves);
};

}  // namespace csgcast
