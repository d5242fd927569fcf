// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "csg/base/box.h"
#include "shade/film/camera.h"

namespace csgcast::detail {

/// Where in a picture a box can be seen: the convex outline of its corners. Beyond it every ray misses the box, so
/// whatever lies in the box costs nothing there.
class Outline {
 public:
  /// Of a box that is not finite, or reaches behind a perspective eye: all of the picture.
  Outline(const CameraFrame& camera, const Box& box);

  struct Columns {
    double first;  ///< places x < first or x > last see nothing of the box
    double last;
  };
  /// Between the heights y0 <= y1 of the picture; with a pixel to spare on each side, which covers all rounding.
  Columns columns(double y0, double y1) const;

 private:
  struct Place {
    double x, y;
  };
  bool is_everywhere_ = false;
  std::vector<Place> corners_;  // of the outline, in order around it
};

}  // namespace csgcast::detail
