// SPDX-License-Identifier: MIT
// Computes t, place and normal of hits, with a ray in each lane. The operations are those of the scalar code in the
// same order, so the numbers do not depend on how a hit was found. Compiled once for each instruction set, by
// lanes.cpp.
#if defined(CSGCAST_LANE_HITS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_HITS_INL_H
#undef CSGCAST_LANE_HITS_INL_H
#else
#define CSGCAST_LANE_HITS_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "csg/exact/quadric_form.h"
#include "raycast/cells/build/cell_data.h"
#include "raycast/packets/detail/lane_events-inl.h"
#include "raycast/packets/detail/lane_line-inl.h"
#include "raycast/packets/detail/lane_quadratic-inl.h"
#include "raycast/packets/detail/lane_round-inl.h"
#include "raycast/scene/scene.h"
#include "raycast/surface/surface.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

/// The tau of a quadric's crossings, as filtered_quadric computes them (quadric_line.cpp). Precondition: the crossings
/// are certain. They are where lanes were certain.
template <class D>
struct Crossings {
  hn::Vec<D> lower, upper;  ///< both are equal if there is only one
  hn::Mask<D> has_two;      ///< true if the sign of a is certain
  hn::Mask<D> opens;        ///< true if a is positive; then f is positive before and after both crossings
};

template <class D>
HWY_INLINE Crossings<D> crossings_of(D d, const QuadraticLanes<D>& f, const LineLanes<D>& line,
                                     const Surface& surface) {
  using V = hn::Vec<D>;
  const V zero = hn::Zero(d);
  const V root = hn::Sqrt(hn::Sub(hn::Mul(f.b, f.b), hn::Mul(f.a, f.c)));
  const V sum = far_sum(d, f.b, root);
  const V near = hn::Add(f.origin, hn::Div(f.c, sum));
  const V far = hn::Add(f.origin, hn::Div(sum, f.a));
  // If the sign of a is certain there are two crossings. Otherwise the near one is the only one.
  const V e = longest(line.direction);
  const V a_error =
      hn::Mul(hn::Mul(hn::Mul(hn::Set(d, 8 * 0x1p-53 * surface.second_degree), e), e), hn::Set(d, 1 + 0x1p-40));
  const auto has_two = hn::Lt(hn::Add(a_error, a_error), hn::Abs(f.a));
  return {hn::IfThenElse(has_two, hn::Min(near, far), near), hn::IfThenElse(has_two, hn::Max(near, far), near), has_two,
          hn::Gt(f.a, zero)};
}

/// The tau of the crossing at which a quadric rises or falls, and the number of that crossing (Crossing::root).
template <class D>
HWY_INLINE hn::Vec<D> crossing_tau(D d, const Crossings<D>& crossings, const Surface& surface, hn::Mask<D> rises,
                                   hn::Vec<BitsOf<D>>& root, hn::Mask<D>& is_open) {
  const BitsOf<D> bits;
  const auto second = hn::Not(hn::Xor(rises, crossings.opens));
  root = hn::IfThenElseZero(hn::RebindMask(bits, hn::And(crossings.has_two, second)), hn::Set(bits, 1));
  // If the surface also matters far away, exact arithmetic finds the other crossing, and may number them differently.
  is_open = surface.is_local ? hn::MaskFromVec(hn::Zero(d)) : hn::Not(crossings.has_two);
  return hn::IfThenElse(second, crossings.upper, crossings.lower);
}

/// The same for any surface. It implements filtered_plane, and also filtered_departure for rays that come back to the
/// surface they depart from (`own`).
template <class D>
HWY_INLINE hn::Vec<D> crossing_tau(D d, const LineLanes<D>& line, const Surface& surface, hn::Mask<D> own,
                                   hn::Mask<D> rises, hn::Vec<BitsOf<D>>& root, hn::Mask<D>& is_open) {
  using V = hn::Vec<D>;
  using Form = QuadricForm;
  const auto& k = surface.local;
  if (surface.is_plane) {
    const Triples<V> normal{hn::Set(d, k[Form::x]), hn::Set(d, k[Form::y]), hn::Set(d, k[Form::z])};
    const V value = hn::Add(dot(normal, line.near), hn::Set(d, k[Form::one]));
    is_open = hn::MaskFromVec(hn::Zero(d));
    root = hn::Zero(BitsOf<D>());
    return hn::Div(hn::Neg(value), dot(normal, line.direction));
  }
  const QuadraticLanes<D> f = quadratic(d, line, surface);
  const Crossings<D> crossings = crossings_of(d, f, line, surface);
  const V tau = crossing_tau(d, crossings, surface, rises, root, is_open);
  if (hn::AllFalse(d, own)) return tau;
  const V middle = hn::Sub(f.origin, hn::Div(f.b, f.a));
  const V other = hn::Add(hn::Add(middle, middle), line.shift);
  root = hn::IfThenZeroElse(hn::RebindMask(BitsOf<D>(), own), root);
  is_open = hn::Or(is_open, hn::AndNot(crossings.has_two, own));
  return hn::IfThenElse(own, other, tau);
}

/// The crossings of a cell's quadrics. Both crossings are computed when one is asked for first.
template <class D>
struct CellCrossings {
  Crossings<D> crossings[Cell::most_slots];
  std::uint64_t known = 0;  ///< one bit for each surface

  /// crossing_tau of the cell's i-th surface.
  HWY_INLINE hn::Vec<D> tau(D d, const LineLanes<D>& line, const Surface& surface, std::uint64_t i, hn::Mask<D> own,
                            hn::Mask<D> rises, hn::Vec<BitsOf<D>>& root, hn::Mask<D>& is_open) {
    if (surface.is_plane || !hn::AllFalse(d, own)) return crossing_tau(d, line, surface, own, rises, root, is_open);
    if (((known >> i) & 1) == 0) {
      crossings[i] = crossings_of(d, quadratic(d, line, surface), line, surface);
      known |= std::uint64_t{1} << i;
    }
    return crossing_tau(d, crossings[i], surface, rises, root, is_open);
  }
};

/// The lanes that depart from a given surface.
template <class D>
HWY_INLINE hn::Mask<D> own_lanes(D d, const Departures<D>* departures, std::uint32_t surface) {
  return departures != nullptr ? departing_from(d, *departures, surface) : hn::MaskFromVec(hn::Zero(d));
}

template <class D>
HWY_INLINE Triples<hn::Vec<D>> place_of(D d, const LineLanes<D>& line, const Frame& frame, hn::Vec<D> tau) {
  using V = hn::Vec<D>;
  const V unit = hn::Set(d, power_of_two(frame.exponent));
  const auto along = [&](V near, V low, V direction, double center) {
    const V q = hn::Add(near, hn::Add(low, hn::Mul(tau, direction)));
    return hn::Add(hn::Set(d, center), hn::Mul(q, unit));
  };
  return {along(line.near.x, line.low.x, line.direction.x, frame.center.x),
          along(line.near.y, line.low.y, line.direction.y, frame.center.y),
          along(line.near.z, line.low.z, line.direction.z, frame.center.z)};
}

/// The surface's unit gradient at a place, as gradient() and normalised() compute it.
template <class D>
HWY_INLINE Triples<hn::Vec<D>> unit_gradient(D d, const Surface& surface, const Frame& frame,
                                             const Triples<hn::Vec<D>>& p) {
  using V = hn::Vec<D>;
  using Form = QuadricForm;
  const auto c = [&](std::size_t term) { return hn::Set(d, surface.local[term]); };
  if (surface.is_plane) return in_all_lanes(d, surface.normal);
  const V to_frame = hn::Set(d, power_of_two(-frame.exponent));
  const auto local = [&](V x, double center, double own) {
    return hn::Sub(hn::Mul(hn::Sub(x, hn::Set(d, center)), to_frame), hn::Set(d, own));
  };
  const Triples<V> q{local(p.x, frame.center.x, surface.center.x), local(p.y, frame.center.y, surface.center.y),
                     local(p.z, frame.center.z, surface.center.z)};
  const V two = hn::Set(d, 2.0);
  const auto row = [&](Form::Term own, V x, Form::Term m1, V y, Form::Term m2, V z, Form::Term linear) {
    return hn::Add(hn::Add(hn::Add(hn::Mul(hn::Mul(two, c(own)), x), hn::Mul(c(m1), y)), hn::Mul(c(m2), z)), c(linear));
  };
  return normalised_lanes(d, Triples<V>{row(Form::xx, q.x, Form::xy, q.y, Form::xz, q.z, Form::x),
                                        row(Form::yy, q.y, Form::xy, q.x, Form::yz, q.z, Form::y),
                                        row(Form::zz, q.z, Form::xz, q.x, Form::yz, q.y, Form::z)});
}

/// The owners of the hits of a packet. An invalid id has all bits set.
template <class U>
struct Owners {
  U surface, leaf, look;
};

template <class D>
HWY_INLINE Owners<hn::Vec<BitsOf<D>>> owners_of(D, const CellData& cells, hn::Vec<BitsOf<D>> slot) {
  const BitsOf<D> bits;
  const hn::RebindToSigned<D> whole;
  const auto offset = hn::BitCast(whole, hn::ShiftLeft<6>(slot));
  static_assert(sizeof(Slot) == 64 && offsetof(Slot, leaf) == offsetof(Slot, surface) + 4 &&
                offsetof(Slot, look) == offsetof(Slot, surface) + 8);
  const auto* words = reinterpret_cast<const std::uint64_t*>(&cells.slots.data()->surface);
  const auto owner = hn::GatherOffset(bits, words, offset);
  const auto look = hn::GatherOffset(bits, words + 1, offset);
  const auto low = hn::Set(bits, 0xffffffffu);
  return {hn::And(owner, low), hn::ShiftRight<32>(owner), hn::And(look, low)};
}

/// The computed numbers of a packet's hits.
template <class D>
struct Told {
  using V = hn::Vec<D>;
  V t;
  hn::Vec<BitsOf<D>> root;  ///< Crossing::root
  hn::Mask<D> left;         ///< lanes that need the scalar code
  hn::Mask<D> unrounded;    ///< lanes whose t needs the scalar code, if t is to be rounded
  Triples<V> place, normal;
};

/// Computes t, places and normals of the hits of one packet, surface by surface.
template <class D>
HWY_INLINE void tell_hits(D d, const Scene& scene, const LineLanes<D>& line, const Departures<D>* departures,
                          hn::Mask<D> hits, hn::Vec<BitsOf<D>> surfaces, hn::Mask<D> rises, hn::Mask<D> enters,
                          bool wants_faces, bool rounds, Told<D>& told) {
  using V = hn::Vec<D>;
  const BitsOf<D> bits;
  HWY_ALIGN std::uint64_t ids[16];
  hn::Store(surfaces, bits, ids);
  const V zero = hn::Zero(d);
  V tau = zero;
  told.t = zero;
  told.left = told.unrounded = hn::MaskFromVec(zero);
  told.root = hn::Zero(bits);
  told.normal = told.place = {zero, zero, zero};
  for (auto rest = hits; !hn::AllFalse(d, rest);) {
    const std::uint64_t id = ids[static_cast<std::size_t>(hn::FindFirstTrue(d, rest))];
    const auto same = hn::And(rest, hn::RebindMask(d, hn::Eq(surfaces, hn::Set(bits, id))));
    rest = hn::AndNot(same, rest);
    const Surface& surface = scene.surfaces()[id];
    hn::Vec<BitsOf<D>> root;
    hn::Mask<D> is_open;
    const auto departing = own_lanes(d, departures, static_cast<std::uint32_t>(id));
    const V own = crossing_tau(d, line, surface, departing, rises, root, is_open);
    told.left = hn::Or(told.left, hn::And(same, is_open));
    told.root = hn::IfThenElse(hn::RebindMask(bits, same), root, told.root);
    tau = hn::IfThenElse(same, own, tau);
    if (rounds) {
      V nearest;
      const auto certain = hn::AndNot(departing, nearest_t_lanes(d, line, surface, own, nearest));
      told.unrounded = hn::Or(told.unrounded, hn::AndNot(certain, same));
      told.t = hn::IfThenElse(hn::And(same, certain), nearest, told.t);
    }
    if (!wants_faces) continue;
    const auto p = place_of(d, line, scene.frame(), own);
    const auto n = unit_gradient(d, surface, scene.frame(), p);
    told.place = choose(same, p, told.place);
    told.normal = choose(same, n, told.normal);
  }
  const V close = hn::Mul(hn::Add(line.shift, tau), line.unit);
  told.t = rounds ? hn::IfThenElse(told.unrounded, close, told.t) : close;
  if (!wants_faces) return;
  told.left = hn::Or(told.left, hn::And(hits, hn::Eq(longest(told.normal), zero)));
  told.left = hn::Or(told.left, hn::And(hits, hn::Not(hn::Lt(longest(told.place), hn::Set(d, 0x1p1000)))));
  // If the ray enters and f falls, or it leaves and f rises, the outside of the solid is on the positive side.
  const auto outside_is_positive = hn::Xor(enters, rises);
  told.normal = choose(outside_is_positive, told.normal, -told.normal);
}

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
