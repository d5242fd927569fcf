// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raycast/surface/form_range.h"
#include "raycast/surface/surface.h"

namespace csgcast::detail {

/// A surface in the form in which lanes compute with it, in the coordinates of the cells.
struct LaneSurface {
  enum class Kind : std::uint8_t {
    // A plane square to an axis of the cells: c[0] is its place, c[1] the sign of its normal.
    plane_x,
    plane_y,
    plane_z,
    // Any other plane. c[0..2] is its normal and c[3] its constant. c[4] is the error of its crossings times |slope|,
    // and c[5] the error of its value.
    plane,
    // A cylinder about a line along an axis. c[0..2] is a center; c[3], c[4] and c[5] are as for a sphere.
    cylinder_x,
    cylinder_y,
    cylinder_z,
    // A sphere. c[0..2] is the center and c[3] the radius². The discriminant must be above c[4]. The sign outside is
    // that of c[5].
    sphere,
    // Any other quadric about a line along an axis: x² + y² - κ z² = ρ about a center. c[0..2] is the center, c[3] is κ
    // and c[4] is ρ. |c[5]| bounds the error of ρ; in a cell's slot it bounds the error of the form anywhere in the
    // cell. The sign of c[5] is the form's sign far from the axis.
    revolved_x,
    revolved_y,
    revolved_z,
    quadric,   // a general quadric; Surface has its numbers
    undecided  // a surface whose doubles decide nothing
  };

  std::array<double, 6> c{};
  Kind kind = Kind::undecided;
};

// Kinds are in this order, planes first, because the ranges below depend on it.
constexpr bool is_plane(LaneSurface::Kind kind) { return kind <= LaneSurface::Kind::plane; }
constexpr bool is_axis_cylinder(LaneSurface::Kind kind) {
  return kind >= LaneSurface::Kind::cylinder_x && kind <= LaneSurface::Kind::cylinder_z;
}
constexpr bool is_round(LaneSurface::Kind kind) { return kind == LaneSurface::Kind::sphere || is_axis_cylinder(kind); }
constexpr bool is_revolved(LaneSurface::Kind kind) {
  return kind >= LaneSurface::Kind::revolved_x && kind <= LaneSurface::Kind::revolved_z;
}
/// The axis that a plane is square to, that a cylinder is along, or that another quadric is about.
constexpr std::size_t axis_of(LaneSurface::Kind kind) {
  const LaneSurface::Kind first = is_plane(kind)      ? LaneSurface::Kind::plane_x
                                  : is_revolved(kind) ? LaneSurface::Kind::revolved_x
                                                      : LaneSurface::Kind::cylinder_x;
  return static_cast<std::size_t>(kind) - static_cast<std::size_t>(first);
}

/// The tolerances that the events of some surfaces need, for any ray.
struct Tolerance {
  float slack = 0;              ///< events need at least this slack, if the ray's own is smaller; a power of two, or 0
  bool may_have_twins = false;  ///< a line may certainly meet one of the surfaces twice within `greatest_slack`
  bool departing_may_have_twins = false;  ///< the same for a ray that departs from a surface

  /// Extends the tolerance to one more surface.
  void allow_for(const LaneSurface& surface);
};

/// Makes the lanes' form of a surface. `turned` is the surface's form in the axes of the cells; null if these are the
/// frame's.
LaneSurface make_lane_surface(const Surface& surface, const CellForm* turned);

/// The value of c[5] of a quadric about an axis, in a cell. It bounds the error of the form along a line, anywhere in
/// the cell's box.
double revolved_off(const LaneSurface& surface, const CellBox& box);

}  // namespace csgcast::detail
