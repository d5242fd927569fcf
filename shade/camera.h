// SPDX-License-Identifier: MIT
#pragma once

#include "csg/scene_description.h"
#include "csg/vector.h"
#include "raycast/ray.h"

namespace csgcast {

/// The rays of a picture's pixels. Pixel (0, 0) is the top left one; its centre is at (0.5, 0.5).
class Camera {
 public:
  /// If `up` is zero or parallel to the view, z serves, or y where the view is along z. Throws Error(bad_value) for
  /// numbers that are not finite, for eye = look_at, for a field of view outside (0, 180) degrees and for a height that
  /// is not positive.
  Camera(const CameraDescription& description, int width, int height);

  /// The ray through a place of the picture, of unit direction: perspective ones start at the eye, parallel ones in the
  /// plane of the eye.
  Ray ray(double x, double y) const;

  /// The width of a pixel in the middle of the picture, at a distance along the ray.
  double footprint(double distance) const { return parallel_ ? pixel_ : pixel_ * distance; }

 private:
  bool parallel_;
  Point eye_;
  Vector forward_;
  Vector right_;  ///< unit, towards greater x
  Vector up_;     ///< unit, towards lesser y
  double width_;
  double height_;
  double pixel_;  ///< the width of a pixel: at distance 1 (perspective) or anywhere (parallel)
};

}  // namespace csgcast
