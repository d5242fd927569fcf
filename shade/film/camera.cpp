// SPDX-License-Identifier: MIT
#include "shade/film/camera.h"

#include <cmath>
#include <numbers>
#include <string>

#include "csg/base/error.h"
#include "csg/base/length.h"

namespace csgcast {
namespace {

[[noreturn]] void refuse(const std::string& problem, const std::string& why, const std::string& remedy) {
  throw Error(ErrorCode::bad_value, {}, problem, why, remedy);
}

void check(const CameraDescription& camera) {
  if (!is_finite(camera.eye) || !is_finite(camera.look_at) || !is_finite(camera.up)) {
    refuse("the camera has a number that is not finite", "eye, look_at and up must be", "give ordinary numbers");
  }
  if (normalised(camera.look_at - camera.eye) == Vector{}) {
    refuse("the camera looks nowhere", "eye and look_at are the same point or too far apart", "move one of them");
  }
  if (camera.height) {
    if (!(*camera.height > 0) || !std::isfinite(*camera.height)) {
      refuse("the camera's height is not positive", "a parallel view shows that much of the scene",
             "give a length above 0");
    }
  } else if (!(camera.fov > 0 && camera.fov < 180)) {
    refuse("the camera's field of view is out of range", "it is the vertical angle of the picture",
           "give degrees between 0 and 180");
  }
}

// Unit and to the right of the view, for the first usable of some vectors as what is up.
Vector right_of(Vector forward, Vector up) {
  constexpr double parallel = 1e-9;  // |sin| of the angle below which rounding would turn the picture about
  for (const Vector candidate : {normalised(up), Vector{0, 0, 1}, Vector{0, 1, 0}}) {
    const Vector right = cross(forward, candidate);
    if (length(right) > parallel) return normalised(right);
  }
  return {1, 0, 0};  // not reached: forward is not along both z and y
}

}  // namespace

Camera::Camera(const CameraDescription& description, int width, int height) {
  check(description);
  CameraFrame& f = frame_;
  f.parallel = description.height.has_value();
  f.eye = description.eye;
  f.width = width;
  f.height = height;
  f.forward = normalised(description.look_at - description.eye);
  f.right = right_of(f.forward, description.up);
  f.up = cross(f.right, f.forward);
  const double extent = f.parallel ? *description.height : 2 * std::tan(description.fov / 360 * std::numbers::pi);
  f.pixel = extent / f.height;
}

Ray Camera::ray(double x, double y) const {
  const CameraFrame& f = frame_;
  const Vector offset = f.pixel * ((x - f.width / 2) * f.right + (f.height / 2 - y) * f.up);
  if (f.parallel) return {f.eye + offset, f.forward};
  return {f.eye, normalised(f.forward + offset)};
}

bool Camera::rays_are_in_range() const {
  const double reach = longest(as_vector(frame_.eye)) + frame_.pixel * (frame_.width + frame_.height);
  return reach < 0.5 * Ray::greatest;
}

}  // namespace csgcast
