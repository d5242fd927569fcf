// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raycast/surface/form_range.h"
#include "raycast/surface/surface.h"

namespace csgcast::detail {

/// A surface as lanes compute with it, in the coordinates of the cells.
struct LaneSurface {
  enum class Kind : std::uint8_t {
    // A plane square to an axis of the cells: c[0] is its place, c[1] the sign of its normal.
    plane_x,
    plane_y,
    plane_z,
    // Any other plane: c[0..2] is its normal, c[3] its constant. c[4] is what its crossings are off times |slope|, c[5]
    // what its value is off.
    plane,
    // A cylinder about a line along an axis: c[0..2] is a center; c[3], c[4] and c[5] are as a sphere's.
    cylinder_x,
    cylinder_y,
    cylinder_z,
    // c[0..2] is the center, c[3] the radius²; the discriminant must be above c[4]; the sign outside is that of c[5].
    sphere,
    // Any other quadric about a line along an axis, x² + y² - κ z² = ρ from a center: c[0..2] is the center, c[3] κ,
    // c[4] ρ. |c[5]| is what ρ is off at most (in a cell's slot: what the form is off, anywhere in the cell); c[5] has
    // the sign that the form has far from the axis.
    revolved_x,
    revolved_y,
    revolved_z,
    quadric,   // Surface has its numbers.
    undecided  // Its doubles decide nothing.
  };

  std::array<double, 6> c{};
  Kind kind = Kind::undecided;
};

// Kinds are in order, planes first: the ranges below depend on it.
constexpr bool is_plane(LaneSurface::Kind kind) { return kind <= LaneSurface::Kind::plane; }
constexpr bool is_axis_cylinder(LaneSurface::Kind kind) {
  return kind >= LaneSurface::Kind::cylinder_x && kind <= LaneSurface::Kind::cylinder_z;
}
constexpr bool is_round(LaneSurface::Kind kind) { return kind == LaneSurface::Kind::sphere || is_axis_cylinder(kind); }
constexpr bool is_revolved(LaneSurface::Kind kind) {
  return kind >= LaneSurface::Kind::revolved_x && kind <= LaneSurface::Kind::revolved_z;
}
/// The axis of a plane square to one, of a cylinder along one, or of another quadric about one.
constexpr std::size_t axis_of(LaneSurface::Kind kind) {
  const LaneSurface::Kind first = is_plane(kind)      ? LaneSurface::Kind::plane_x
                                  : is_revolved(kind) ? LaneSurface::Kind::revolved_x
                                                      : LaneSurface::Kind::cylinder_x;
  return static_cast<std::size_t>(kind) - static_cast<std::size_t>(first);
}

/// What the events of some surfaces need, whatever the ray.
struct Tolerance {
  float slack = 0;              ///< events need at least this, if not the ray's own slack: a power of two, or 0
  bool may_have_twins = false;  ///< a line may be certain to meet one of the surfaces twice within `greatest_slack`
  bool departing_may_have_twins = false;  ///< the same of a ray that departs from a surface

  /// Adds a surface.
  void allow_for(const LaneSurface& surface);
};

/// A surface of a scene for lanes. `turned` is its form in the axes of the cells; null if these are the frame's.
LaneSurface make_lane_surface(const Surface& surface, const CellForm* turned);

/// What c[5] of a quadric about an axis becomes in a cell: it bounds what the form may be off along a line, anywhere in
/// the cell's box.
double revolved_off(const LaneSurface& surface, const CellBox& box);

}  // namespace csgcast::detail
