// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raycast/cells/formula/form_range.h"
#include "raycast/surface/surface.h"

namespace csgcast::detail {

/// A surface as the lanes compute with it.
struct LaneSurface {
  enum class Kind : std::uint8_t {
    plane_x,  ///< square to an axis of the cells: c[0] its place, c[1] the sign of its normal
    plane_y,
    plane_z,
    plane,       ///< c[0..2] normal, c[3] constant, c[4] what its crossings are off times |slope|, c[5] of its value
    cylinder_x,  ///< about a line along an axis: c[0..2] center, c[3] radius², c[4], c[5] as of a sphere
    cylinder_y,
    cylinder_z,
    sphere,  ///< c[0..2] center, c[3] radius², c[4] what the discriminant must be above, c[5] the sign inside is - it
    revolved_x,  ///< any other quadric about a line along an axis, x² + y² - κ z² = ρ from a center: c[0..2] center,
    revolved_y,  ///< c[3] κ, c[4] ρ, c[5] what ρ is off at most (in a cell's slot: the form, anywhere in the cell),
                 ///< with the sign that the form has far from the axis
    revolved_z,
    quadric,   ///< Surface has it
    undecided  ///< its doubles decide nothing
  };

  std::array<double, 6> c{};
  Kind kind = Kind::undecided;
};

/// Kinds are in order: planes first.
constexpr bool is_plane(LaneSurface::Kind kind) { return kind <= LaneSurface::Kind::plane; }
constexpr bool is_axis_cylinder(LaneSurface::Kind kind) {
  return kind >= LaneSurface::Kind::cylinder_x && kind <= LaneSurface::Kind::cylinder_z;
}
constexpr bool is_round(LaneSurface::Kind kind) { return kind == LaneSurface::Kind::sphere || is_axis_cylinder(kind); }
constexpr bool is_revolved(LaneSurface::Kind kind) {
  return kind >= LaneSurface::Kind::revolved_x && kind <= LaneSurface::Kind::revolved_z;
}
/// Of a plane square to an axis, of a cylinder along one, or of another quadric about one.
constexpr std::size_t axis_of(LaneSurface::Kind kind) {
  const LaneSurface::Kind first = is_plane(kind)      ? LaneSurface::Kind::plane_x
                                  : is_revolved(kind) ? LaneSurface::Kind::revolved_x
                                                      : LaneSurface::Kind::cylinder_x;
  return static_cast<std::size_t>(kind) - static_cast<std::size_t>(first);
}

/// What the events of some surfaces need, whatever the ray.
struct Tolerance {
  float slack = 0;              ///< a power of two, or none
  bool may_have_twins = false;  ///< a line may meet one of them twice within slack of cells, and be certain of it
  bool departing_may_have_twins = false;  ///< a ray may that departs from a surface

  void allow_for(const LaneSurface& surface);
};

/// `turned`: the surface's form in the axes of the cells; null: these are the frame's.
LaneSurface make_lane_surface(const Surface& surface, const CellForm* turned);

/// c[5] of a quadric about an axis in a cell: what its form may be off along a line, anywhere in the cell's box.
double revolved_off(const LaneSurface& surface, const CellBox& box);

}  // namespace csgcast::detail
