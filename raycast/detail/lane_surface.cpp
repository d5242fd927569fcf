// SPDX-License-Identifier: MIT
#include "raycast/detail/lane_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "raycast/detail/cell_data.h"

// The constants by which lanes know what is certain. They hold for rays whose point near the frame's center lies within
// |q| <= 4 and events within |tau| <= 8 of it; derived in docs/accuracy.md, "Lanes".

namespace csgcast::detail {
namespace {

using Form = QuadricForm;
constexpr double u = 0x1p-53;

LaneSurface plane(const Surface& surface) {
  const auto& k = surface.local;
  LaneSurface lane;
  const Vector n{k[Form::x], k[Form::y], k[Form::z]};
  const double w = k[Form::one];
  const Vector normal = normalised(n);
  const std::array<double, 3> unit{normal.x, normal.y, normal.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double size = std::fabs(n[axis]);
    if (size != longest(n) || surface.first_degree != size) continue;
    lane.kind = static_cast<LaneSurface::Kind>(axis);
    lane.c = {-w / n[axis], n[axis] > 0 ? 1.0 : -1.0};
    lane.center = unit;
    // Farther out the bounds would not hold, nor does anybody look there.
    if (!(std::fabs(lane.c[0]) < 1)) lane.kind = LaneSurface::Kind::undecided;
    return lane;
  }
  lane.kind = LaneSurface::Kind::plane;
  const double slack = 4 * u * (264 * surface.first_degree + 12 * surface.constant);
  const double value_error = u * (160 * surface.first_degree + 12 * surface.constant);
  lane.c = {n.x, n.y, n.z, w, slack, value_error};
  lane.center = unit;
  return lane;
}

bool is_sphere(const Surface::Coefficients& k) {
  return k[Form::xx] == k[Form::yy] && k[Form::yy] == k[Form::zz] && k[Form::xy] == 0 && k[Form::xz] == 0 &&
         k[Form::yz] == 0 && k[Form::xx] != 0;
}

LaneSurface sphere(const Surface& surface) {
  const auto& k = surface.local;
  LaneSurface lane;
  const double a = k[Form::xx];
  const Vector to_center = (-0.5 / a) * Vector{k[Form::x], k[Form::y], k[Form::z]};
  const Vector center = surface.center + to_center;
  const double radius_squared = dot(to_center, to_center) - k[Form::one] / a;
  if (!(radius_squared > 0) || !(radius_squared < 1) || !(longest(center) < 1)) return lane;
  lane.kind = LaneSurface::Kind::sphere;
  const double least = std::fmax(0x1p-16 * radius_squared, 0x1p-43 * std::sqrt(radius_squared));
  lane.c = {center.x, center.y, center.z, radius_squared, least, a > 0 ? 1.0 : -1.0};
  return lane;
}

// x² + y² = r² about a center, and the same along the other axes.
LaneSurface cylinder(const Surface& surface, std::size_t axis) {
  const auto& k = surface.local;
  LaneSurface lane;
  const std::size_t i = (axis + 1) % 3;
  const std::size_t j = (axis + 2) % 3;
  const bool is_round = k[Form::xx + i] == k[Form::xx + j] && k[Form::xx + i] != 0 && k[Form::xx + axis] == 0 &&
                        k[Form::xy] == 0 && k[Form::xz] == 0 && k[Form::yz] == 0 && k[Form::x + axis] == 0;
  if (!is_round) return lane;
  const double a = k[Form::xx + i];
  Vector to_center;
  to_center[i] = -0.5 / a * k[Form::x + i];
  to_center[j] = -0.5 / a * k[Form::x + j];
  const Vector center = surface.center + to_center;
  const double radius_squared = dot(to_center, to_center) - k[Form::one] / a;
  if (!(radius_squared > 0x1p-40) || !(radius_squared < 1) || !(longest(center) < 1)) return lane;
  lane.kind = static_cast<LaneSurface::Kind>(static_cast<std::size_t>(LaneSurface::Kind::cylinder_x) + axis);
  lane.c = {center.x, center.y, center.z, radius_squared, 0x1p-17 * radius_squared, a > 0 ? 1.0 : -1.0};
  return lane;
}

LaneSurface quadric(const Surface& surface) {
  LaneSurface lane;
  // Reach is counted from centers within the frame's cube.
  if (!(longest(surface.center) < 0.75)) return lane;
  lane.kind = LaneSurface::Kind::quadric;
  lane.c = surface.local;
  lane.center = {surface.center.x, surface.center.y, surface.center.z};
  lane.second_degree = surface.second_degree;
  lane.first_degree = surface.first_degree;
  lane.constant = surface.constant;
  return lane;
}

LaneSurface kind_of(const Surface& surface) {
  if (!surface.in_range) return {};
  if (surface.kind == SurfaceKind::plane) return plane(surface);
  if (is_sphere(surface.local)) {
    const LaneSurface lane = sphere(surface);
    if (lane.kind != LaneSurface::Kind::undecided) return lane;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const LaneSurface lane = cylinder(surface, axis);
    if (lane.kind != LaneSurface::Kind::undecided) return lane;
  }
  return quadric(surface);
}

}  // namespace

LaneSurface make_lane_surface(const Surface& surface) {
  LaneSurface lane = kind_of(surface);
  const auto& k = surface.local;
  lane.is_mixed = k[Form::xy] != 0 || k[Form::xz] != 0 || k[Form::yz] != 0;
  return lane;
}

}  // namespace csgcast::detail
