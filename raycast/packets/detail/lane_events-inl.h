// SPDX-License-Identifier: MIT
// Computes where lines cross planes, spheres and cylinders, with a ray in each lane, and which lanes are not certain.
// The bounds are in docs/accuracy.md, "Lanes". Compiled once for each instruction set, by lanes.cpp.
#if defined(CSGCAST_LANE_EVENTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_EVENTS_INL_H
#undef CSGCAST_LANE_EVENTS_INL_H
#else
#define CSGCAST_LANE_EVENTS_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "raycast/cells/build/cell_data.h"
#include "raycast/packets/detail/lane_line-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

/// The logarithm of a power of two below 2^63. It is the exponent of the same number as a double.
template <class D>
HWY_INLINE hn::Vec<BitsOf<D>> logarithm(D d, hn::Vec<BitsOf<D>> power) {
  const hn::RebindToSigned<D> whole;
  return hn::Sub(biased_exponent(d, hn::ConvertTo(d, hn::BitCast(whole, power))), hn::Set(BitsOf<D>(), 1023));
}

/// True if two or more bits of a word are set.
template <class D>
HWY_INLINE hn::Mask<D> has_several_bits(D d, hn::Vec<BitsOf<D>> word) {
  const BitsOf<D> bits;
  const auto rest = hn::And(word, hn::Sub(word, hn::Set(bits, 1)));
  return hn::RebindMask(d, hn::Ne(rest, hn::Zero(bits)));
}

/// The crossings of the surfaces of one cell. If a surface is positive before its two events, it is positive after an
/// even number of them.
template <class D>
struct Events {
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  static constexpr std::size_t more = hn::is_single<D> ? 8 : 0;  // loads of whole registers reach beyond the last event

  V first[Cell::most_slots + more];
  V second[Cell::most_slots + more];
  hn::Vec<BitsOf<D>> before;  ///< the state before all of them
  V slack;                    ///< four times the error bound of any event
  M flagged;                  ///< lanes that are not certain
};

/// Sets whether surface i is positive before its events.
template <class D>
HWY_INLINE void set_before(Events<D>& events, std::size_t i, hn::Mask<D> positive) {
  const BitsOf<D> bits;
  const auto bit = hn::Set(bits, std::uint64_t{1} << i);
  events.before = hn::Or(events.before, hn::IfThenElseZero(hn::RebindMask(bits, positive), bit));
}

/// The same for all lanes.
template <class D>
HWY_INLINE void set_before(D, Events<D>& events, std::size_t i, bool positive) {
  events.before = hn::Or(events.before, hn::Set(BitsOf<D>(), std::uint64_t{positive} << i));
}

/// The surface that each ray departs from, in lanes.
template <class D>
struct Departures {
  hn::Mask<D> positive;
  hn::Vec<BitsOf<D>> surface;
};

template <class D>
HWY_INLINE hn::Mask<D> departing_from(D d, const Departures<D>& departures, std::uint32_t surface) {
  return hn::RebindMask(d, hn::Eq(departures.surface, hn::Set(BitsOf<D>(), surface)));
}

template <class D>
HWY_INLINE void flag(Events<D>& events, hn::Mask<D> lanes) {
  if constexpr (certified) events.flagged = hn::Or(events.flagged, lanes);
}

/// Widens the slack for an event whose error is a quarter of `slack`.
template <class D>
HWY_INLINE void widen(Events<D>& events, hn::Vec<D> slack) {
  if constexpr (certified) events.slack = hn::Max(events.slack, slack);
}

/// A plane square to an axis of the frame.
template <class D>
HWY_INLINE void axis_plane_events(D d, const LineLanes<D>& line, const Slot& plane, std::size_t axis, std::size_t i,
                                  Events<D>& events) {
  using V = hn::Vec<D>;
  events.first[i] = tau_at(d, line, axis, plane.c[0]);
  // It is unpredictable which way planes face.
  const V against = hn::Mul(hn::Set(d, plane.c[1]), line.axis_inverse[axis]);
  set_before(events, i, hn::Lt(against, hn::Zero(d)));
  if (!line.any_is_loose) return;
  const Triples<V>& near = line.walk_near;
  const V gap = hn::Sub(hn::Set(d, plane.c[0]), axis == 0 ? near.x : axis == 1 ? near.y : near.z);
  flag(events, hn::Lt(hn::Abs(gap), line.guard[axis]));
}

/// If lanes depart from a surface, they see only crossings ahead. After a plane there is none, and the slope tells the
/// side.
template <class D>
HWY_INLINE void depart_from_axis_plane(D d, const LineLanes<D>& line, std::size_t axis, hn::Mask<D> lanes,
                                       std::size_t i, Events<D>& events) {
  events.first[i] = hn::IfThenElse(lanes, hn::Neg(hn::Inf(d)), events.first[i]);
  flag(events, hn::And(lanes, hn::Gt(hn::Abs(line.axis_inverse[axis]), hn::Set(d, 0x1p40))));
}

template <class D>
HWY_INLINE void plane_events(D d, const LineLanes<D>& line, const Slot& plane, hn::Mask<D> departing, std::size_t i,
                             Events<D>& events) {
  using V = hn::Vec<D>;
  const Triples<V> n{hn::Set(d, plane.c[0]), hn::Set(d, plane.c[1]), hn::Set(d, plane.c[2])};
  const V slope = fused_dot(n, line.direction);
  const V value = hn::Add(fused_dot(n, line.near), hn::Set(d, plane.c[3]));
  const V size = hn::Abs(slope);
  const V tiny = hn::Set(d, 1e-250);
  const V inverse = hn::Div(hn::Set(d, 1.0), hn::IfThenElse(hn::Lt(size, tiny), tiny, slope));
  const V at = hn::Neg(hn::Mul(value, inverse));
  const V off = hn::Mul(hn::Set(d, plane.c[4]), hn::Abs(inverse));
  const auto is_loose = hn::Gt(off, hn::Set(d, greatest_slack));
  widen(events, hn::IfThenZeroElse(is_loose, off));
  const V out_of_reach = hn::Add(hn::Set(d, plane.c[5]), hn::Mul(hn::Set(d, 8.5), size));
  const auto is_open = hn::Or(hn::Lt(hn::Abs(value), out_of_reach), departing);
  flag(events, hn::And(is_loose, is_open));
  events.first[i] = hn::IfThenElse(departing, hn::Neg(hn::Inf(d)), at);
  set_before(events, i, hn::Lt(slope, hn::Zero(d)));
}

/// A ray that departs from a sphere or cylinder has no event at its start. If it goes inwards, it has one at the mirror
/// image of the start in the `middle` of the two. That event must be farther off than `least`.
template <class D>
HWY_INLINE void depart_from_round(D d, const LineLanes<D>& line, hn::Vec<D> middle, bool outside_is_positive,
                                  double least, hn::Mask<D> departing, const Departures<D>& departures, std::size_t i,
                                  Events<D>& events) {
  using V = hn::Vec<D>;
  const auto outwards = outside_is_positive ? departures.positive : hn::Not(departures.positive);
  const V other = hn::Sub(hn::Add(middle, middle), line.start);
  const V before = hn::Neg(hn::Inf(d));
  events.first[i] = hn::IfThenElse(departing, before, events.first[i]);
  events.second[i] = hn::IfThenElse(departing, hn::IfThenElse(outwards, before, other), events.second[i]);
  const V gap = hn::Sub(other, line.start);
  const auto too_near = hn::Lt(gap, hn::Set(d, least));
  flag(events, hn::AndNot(outwards, hn::And(departing, too_near)));
  // If a ray goes to the other side than its departure says, the cells and the departure disagree.
  flag(events, hn::And(outwards, hn::And(departing, hn::Gt(gap, hn::Set(d, 2 * greatest_slack)))));
}

template <class V>
struct SphereCrossings {
  V first, second;  ///< infinite if there is no event
  V middle, discriminant;
};

/// `v` is the vector from a sphere's center to the line's point near it.
template <class D>
HWY_INLINE SphereCrossings<hn::Vec<D>> sphere_crossings(D d, const Triples<hn::Vec<D>>& v,
                                                        const Triples<hn::Vec<D>>& direction,
                                                        hn::Vec<D> inverse_squared, hn::Vec<D> radius_squared) {
  using V = hn::Vec<D>;
  const V middle = hn::Mul(hn::Neg(fused_dot(v, direction)), inverse_squared);
  const Triples<V> closest{hn::MulAdd(middle, direction.x, v.x), hn::MulAdd(middle, direction.y, v.y),
                           hn::MulAdd(middle, direction.z, v.z)};
  const V discriminant = hn::Sub(radius_squared, fused_dot(closest, closest));
  const auto misses = hn::Lt(discriminant, hn::Zero(d));
  const V half = hn::Sqrt(hn::Mul(hn::Max(discriminant, hn::Zero(d)), inverse_squared));
  const V never = hn::Inf(d);
  return {hn::IfThenElse(misses, never, hn::Sub(middle, half)), hn::IfThenElse(misses, never, hn::Add(middle, half)),
          middle, discriminant};
}

template <class D>
HWY_INLINE void sphere_events(D d, const LineLanes<D>& line, const Slot& sphere, hn::Mask<D> departing,
                              const Departures<D>* departures, std::size_t i, Events<D>& events) {
  using V = hn::Vec<D>;
  const Triples<V> center{hn::Set(d, sphere.c[0]), hn::Set(d, sphere.c[1]), hn::Set(d, sphere.c[2])};
  const auto crossings =
      sphere_crossings(d, line.near - center, line.direction, line.inverse_squared, hn::Set(d, sphere.c[3]));
  events.first[i] = crossings.first;
  events.second[i] = crossings.second;
  const bool outside_is_positive = sphere.c[5] > 0;
  set_before(d, events, i, outside_is_positive);
  const auto is_open = hn::Le(hn::Abs(crossings.discriminant), hn::Set(d, sphere.c[4]));
  if (departures == nullptr) return flag(events, is_open);
  flag(events, hn::AndNot(departing, is_open));
  depart_from_round(d, line, crossings.middle, outside_is_positive, 2 * round_slack, departing, *departures, i, events);
}

/// A cylinder about a line along an axis of the cells is a circle in the plane of the other two axes. Rays nearly along
/// the axis do not meet it within reach, or are left to the caster.
template <class D>
HWY_INLINE void cylinder_events(D d, const LineLanes<D>& line, const AxisBounds& bounds, const Slot& cylinder,
                                std::size_t axis, hn::Mask<D> departing, const Departures<D>* departures, std::size_t i,
                                Events<D>& events) {
  using V = hn::Vec<D>;
  const V near[3] = {line.walk_near.x, line.walk_near.y, line.walk_near.z};
  const V along[3] = {line.walk_direction.x, line.walk_direction.y, line.walk_direction.z};
  const std::size_t j = (axis + 1) % 3;
  const std::size_t k = (axis + 2) % 3;
  const V zero = hn::Zero(d);
  const V vj = hn::Sub(near[j], hn::Set(d, cylinder.c[j]));
  const V vk = hn::Sub(near[k], hn::Set(d, cylinder.c[k]));
  const V inverse = line.across_inverse[axis];
  const V middle = hn::Neg(hn::Mul(hn::MulAdd(vj, along[j], hn::Mul(vk, along[k])), inverse));
  const V qj = hn::MulAdd(middle, along[j], vj);
  const V qk = hn::MulAdd(middle, along[k], vk);
  const V radius_squared = hn::Set(d, cylinder.c[3]);
  const V discriminant = hn::Sub(radius_squared, hn::MulAdd(qj, qj, hn::Mul(qk, qk)));
  const V half = hn::Sqrt(hn::Mul(hn::Max(discriminant, zero), inverse));
  const V never = hn::Inf(d);
  const bool outside_is_positive = cylinder.c[5] > 0;
  auto misses = hn::Lt(discriminant, zero);
  const V size = hn::Abs(discriminant);
  auto is_open = hn::Le(size, hn::Mul(hn::Set(d, cylinder.c[4]), inverse));
  auto is_steep = hn::MaskFromVec(zero);
  auto stays_inside = is_steep;
  if (line.any_is_steep[axis]) {
    // For a ray along the axis, the discriminant was computed at `near`, as there is no middle. Its sign is valid for
    // the whole ray.
    is_steep = hn::Ge(line.across_size[axis], zero);
    stays_inside = hn::AndNot(misses, is_steep);
    misses = hn::Or(is_steep, misses);
    const V too_near = hn::MulAdd(hn::Set(d, 96.0), line.across_size[axis], hn::Set(d, bounds.off_axis));
    is_open = hn::Or(hn::And(is_steep, hn::Le(size, too_near)), hn::AndNot(is_steep, is_open));
  }
  events.first[i] = hn::IfThenElse(misses, never, hn::Sub(middle, half));
  events.second[i] = hn::IfThenElse(misses, never, hn::Add(middle, half));
  set_before(events, i, outside_is_positive ? hn::Not(stays_inside) : stays_inside);
  if (departures == nullptr) return flag(events, is_open);
  flag(events, hn::AndNot(departing, is_open));
  flag(events, hn::And(departing, is_steep));
  depart_from_round(d, line, middle, outside_is_positive, 2 * round_slack, departing, *departures, i, events);
}

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
