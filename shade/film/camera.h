// SPDX-License-Identifier: MIT
#pragma once

#include "csg/base/vector.h"
#include "csg/solid/scene_description.h"
#include "raycast/line/ray.h"

namespace csgcast {

/// What a camera's rays are made of: forward + pixel ((x - width / 2) right + (height / 2 - y) up) from the eye, or, of
/// a parallel camera, forward from the eye moved by that offset.
struct CameraFrame {
  bool parallel = false;
  Point eye;
  Vector forward;
  Vector right;  ///< unit, towards greater x
  Vector up;     ///< unit, towards lesser y
  double width = 1;
  double height = 1;
  double pixel = 1;  ///< the width of a pixel: at distance 1 (perspective) or anywhere (parallel)
};

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
  double footprint(double distance) const { return frame_.parallel ? frame_.pixel : frame_.pixel * distance; }

  /// Whether all rays are sure to be within Ray::in_range.
  bool rays_are_in_range() const;

  const CameraFrame& frame() const { return frame_; }

 private:
  CameraFrame frame_;
};

}  // namespace csgcast
