// SPDX-License-Identifier: MIT
// Computes where lines cross the surfaces of a cell, with a ray in each lane. Compiled once for each instruction set,
// by lanes.cpp.
#if defined(CSGCAST_LANE_CELL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_CELL_INL_H
#undef CSGCAST_LANE_CELL_INL_H
#else
#define CSGCAST_LANE_CELL_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "raycast/cells/build/cell_data.h"
#include "raycast/packets/detail/lane_events-inl.h"
#include "raycast/packets/detail/lane_line-inl.h"
#include "raycast/packets/detail/lane_quadratic-inl.h"
#include "raycast/scene/scene.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

/// Far from the frame's cube the error of a plane's event is larger: the error of the slope counts in proportion to the
/// distance. Events that are too uncertain are left to the caster.
template <class D>
HWY_INLINE void loosen_far_events(D d, const LineLanes<D>& line, const Slot& plane, hn::Mask<D> departing,
                                  std::size_t i, Events<D>& events) {
  using V = hn::Vec<D>;
  if (plane.kind < LaneSurface::Kind::plane) {
    if (!line.any_is_loose) return;
    const V guard = line.guard[axis_of(plane.kind)];
    return flag(events, hn::AndNot(departing, hn::Ge(guard, hn::Zero(d))));
  }
  const Triples<V> n{hn::Set(d, plane.c[0]), hn::Set(d, plane.c[1]), hn::Set(d, plane.c[2])};
  const V slope = hn::Abs(dot(n, line.direction));
  const V ways = hn::MulAdd(hn::Set(d, 0.125), hn::Abs(events.first[i]), hn::Set(d, 1.0));
  const V off = hn::Div(hn::Mul(hn::Set(d, plane.c[4]), ways), slope);
  const auto is_sound = hn::Or(departing, hn::Le(off, hn::Set(d, greatest_slack)));
  flag(events, hn::Not(is_sound));
  widen(events, hn::IfThenElseZero(hn::AndNot(departing, is_sound), off));
}

/// Starts without any events.
template <class D>
HWY_INLINE void clear_events(D d, const LineLanes<D>& line, double slack, Events<D>& events) {
  events.slack = certified ? hn::Max(line.slack, hn::Set(d, slack)) : line.slack;
  events.flagged = hn::MaskFromVec(hn::Zero(d));
  events.before = hn::Zero(BitsOf<D>());
}

/// Adds the events of one surface, as number i.
template <class D>
HWY_INLINE void add_events(D d, const Scene& scene, const LineLanes<D>& line, const AxisBounds& bounds,
                           const Slot& surface, const Departures<D>* departures, std::size_t i, Events<D>& events) {
  using Kind = LaneSurface::Kind;
  const std::uint32_t id = surface.surface;
  const auto departing = departures != nullptr ? departing_from(d, *departures, id) : hn::MaskFromVec(hn::Zero(d));
  switch (surface.kind) {
    case Kind::plane_x:
    case Kind::plane_y:
    case Kind::plane_z: {
      const auto axis = static_cast<std::size_t>(surface.kind);
      axis_plane_events(d, line, surface, axis, i, events);
      if (departures != nullptr) depart_from_axis_plane(d, line, axis, departing, i, events);
      break;
    }
    case Kind::plane:
      plane_events(d, line, surface, departing, i, events);
      break;
    case Kind::cylinder_x:
    case Kind::cylinder_y:
    case Kind::cylinder_z:
      cylinder_events(d, line, bounds, surface, axis_of(surface.kind), departing, departures, i, events);
      break;
    case Kind::sphere:
      sphere_events(d, line, surface, departing, departures, i, events);
      break;
    case Kind::revolved_x:
    case Kind::revolved_y:
    case Kind::revolved_z:
      if (departures == nullptr) {
        revolved_events(d, line, surface, axis_of(surface.kind), i, events);
        break;
      }
      [[fallthrough]];
    default:
      quadric_events(d, line, scene.surfaces()[id], departing, departures, i, events);
  }
}

/// Adds the events of all surfaces of a cell.
template <class D>
HWY_INLINE void cell_events(D d, const Scene& scene, const LineLanes<D>& line, const CellData& cells, const Cell& cell,
                            const Departures<D>* departures, Events<D>& events) {
  clear_events(d, line, cell.tolerance.slack, events);
  std::size_t i = 0;
  if (departures == nullptr && !cell.is_far) {
    for (; i < cell.axis_plane_count; ++i) {
      const Slot& plane = cells.slots[cell.first_slot + i];
      axis_plane_events(d, line, plane, static_cast<std::size_t>(plane.kind), i, events);
    }
  }
  for (; i < cell.slot_count; ++i) {
    const Slot& surface = cells.slots[cell.first_slot + i];
    add_events(d, scene, line, cells.axis_bounds, surface, departures, i, events);
    if (!cell.is_far) continue;
    const auto nobody = hn::MaskFromVec(hn::Zero(d));
    const auto departing = departures != nullptr ? departing_from(d, *departures, surface.surface) : nobody;
    loosen_far_events(d, line, surface, departing, i, events);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
