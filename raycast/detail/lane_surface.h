// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raycast/detail/form_range.h"
#include "raycast/surface.h"

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
    sphere,   ///< c[0..2] center, c[3] radius², c[4] what the discriminant must be above, c[5] the sign inside is - it
    quadric,  ///< Surface has it
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
/// Of a plane square to an axis, or of a cylinder along one.
constexpr std::size_t axis_of(LaneSurface::Kind kind) {
  return static_cast<std::size_t>(kind) -
         (is_plane(kind) ? std::size_t{0} : static_cast<std::size_t>(LaneSurface::Kind::cylinder_x));
}

/// Whether a line may meet the surface twice within slack of cells, and be certain of it.
bool may_have_twins(const LaneSurface& surface);

/// `turned`: the surface's form in the axes of the cells; null: these are the frame's.
LaneSurface make_lane_surface(const Surface& surface, const CellForm* turned);

}  // namespace csgcast::detail
