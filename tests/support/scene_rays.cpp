// SPDX-License-Identifier: MIT
#include "tests/support/scene_rays.h"

#include <cmath>
#include <optional>

#include "csg/base/length.h"
#include "csg/exact/quadric_form.h"

namespace csgcast::test {
namespace {

// The axis that a plane is square to, if any.
std::optional<std::size_t> axis_of(const Surface& plane) {
  const QuadricForm form = plane.exact.unpacked();
  std::optional<std::size_t> axis;
  for (std::size_t k = 0; k < 3; ++k) {
    if (form.coefficient[QuadricForm::x + k].is_zero()) continue;
    if (axis) return std::nullopt;
    axis = k;
  }
  return axis;
}

}  // namespace

SceneRays::SceneRays(const Scene& scene, std::uint64_t seed)
    : box_(scene.bounded_leaves()), size_(length(box_.size())), random_(seed) {
  for (const Surface& surface : scene.surfaces()) {
    if (!surface.is_plane) continue;
    if (const auto axis = axis_of(surface))
      planes_[*axis].push_back(-surface.world[QuadricForm::one] / surface.world[QuadricForm::x + *axis]);
  }
}

Point SceneRays::anywhere() {
  Point p;
  for (std::size_t axis = 0; axis < 3; ++axis)
    p[axis] = box_.lower[axis] + (box_.upper[axis] - box_.lower[axis]) * random_.number(-0.1, 1.1);
  return p;
}

double SceneRays::coordinate(std::size_t axis) {
  const std::vector<double>& planes = planes_[axis];
  return planes.empty() ? anywhere()[axis] : planes[random_.index(planes.size())];
}

Point SceneRays::corner() { return {coordinate(0), coordinate(1), coordinate(2)}; }

Ray SceneRays::through_anywhere() {
  const Point target = anywhere();
  const Vector d = normalised(random_.direction());
  return Ray(target - (2 * size_) * d, d);
}

Ray SceneRays::along_an_axis() {
  Point from = anywhere();
  const std::size_t axis = random_.index(3);
  const double sign = random_.index(2) == 0 ? 1 : -1;
  from[axis] -= sign * 2 * size_;
  Vector d;
  d[axis] = sign;
  return Ray(from, d);
}

Ray SceneRays::along_an_edge() {
  Point from = corner();
  const std::size_t axis = random_.index(3);
  Vector d;
  d[axis] = random_.index(2) == 0 ? 1 : -1;
  if (random_.index(2) == 0) from[axis] -= size_ * d[axis];
  return Ray(from, d);
}

Ray SceneRays::in_a_face() {
  const std::size_t axis = random_.index(3);
  Vector d = random_.direction();
  Point from = anywhere() - size_ * d;
  d[axis] = 0;
  from[axis] = coordinate(axis);
  if (d == Vector{}) d[(axis + 1) % 3] = 1;
  return Ray(from, d);
}

Ray SceneRays::through_a_corner() {
  Vector d{std::floor(random_.number(-3, 4)), std::floor(random_.number(-3, 4)), std::floor(random_.number(-3, 4))};
  if (d == Vector{}) d.x = 1;
  // A power of two times a small whole number: of round coordinates the corner stays on the ray exactly.
  const double steps = std::exp2(std::ceil(std::log2(size_)));
  return Ray(corner() - steps * d, d);
}

Ray SceneRays::between_corners() {
  const Point from = corner();
  const Vector d = corner() - from;
  return Ray(from, d == Vector{} ? Vector{1, 0, 0} : d);
}

Ray SceneRays::next() {
  switch (random_.index(6)) {
    case 0:
      return through_anywhere();
    case 1:
      return along_an_axis();
    case 2:
      return along_an_edge();
    case 3:
      return in_a_face();
    case 4:
      return through_a_corner();
    default:
      return between_corners();
  }
}

}  // namespace csgcast::test
