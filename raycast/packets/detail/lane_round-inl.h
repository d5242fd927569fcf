// SPDX-License-Identifier: MIT
// Computes the nearest double to a crossing's t, with a ray in each lane, as nearest_t.cpp does: by one Newton step on
// a residual in twofold arithmetic. A certain result is the same number however it was found, so the operations need
// not be the same. Compiled once for each instruction set, by lanes.cpp.
#if defined(CSGCAST_LANE_ROUND_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_ROUND_INL_H
#undef CSGCAST_LANE_ROUND_INL_H
#else
#define CSGCAST_LANE_ROUND_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "csg/base/length.h"
#include "csg/exact/quadric_form.h"
#include "raycast/packets/detail/lane_line-inl.h"
#include "raycast/surface/surface.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

/// Computes a + b, off by at most 3 u² (|a| + |b|). Two sums round: that of the low parts, and its sum with the high
/// parts' remainder.
template <class V>
HWY_INLINE Exact<V> sum_of(const Exact<V>& a, const Exact<V>& b) {
  const Exact<V> high = two_sum(a.high, b.high);
  return fast_two_sum(high.high, hn::Add(high.low, hn::Add(a.low, b.low)));
}

/// Computes a b, off by a relative 7 u² (DWTimesDW1, see twofold.h).
template <class D>
HWY_INLINE Exact<hn::Vec<D>> product_of(D d, const Exact<hn::Vec<D>>& a, const Exact<hn::Vec<D>>& b) {
  const Exact<hn::Vec<D>> high = two_product(d, a.high, b.high);
  const hn::Vec<D> cross = hn::Add(hn::Mul(a.high, b.low), hn::Mul(a.low, b.high));
  return fast_two_sum(high.high, hn::Add(high.low, cross));
}

/// A surface's value and slope near a crossing, with numbers that bound their errors.
template <class D>
struct Residual {
  using V = hn::Vec<D>;
  Exact<V> value;
  V slope;
  V size;  ///< the greatest coordinate, relative to the surface's center
};

template <class D>
HWY_INLINE Residual<D> residual_at(D d, const LineLanes<D>& line, const Surface& surface, hn::Vec<D> tau) {
  using V = hn::Vec<D>;
  using Form = QuadricForm;
  const V zero = hn::Zero(d);
  const auto along = [&](V near, V low, V direction, double center) {
    Exact<V> start = two_sum(near, hn::Set(d, -center));
    start.low = hn::Add(start.low, low);
    return sum_of(start, two_product(d, tau, direction));
  };
  const Exact<V> q[3] = {along(line.near.x, line.low.x, line.direction.x, surface.center.x),
                         along(line.near.y, line.low.y, line.direction.y, surface.center.y),
                         along(line.near.z, line.low.z, line.direction.z, surface.center.z)};
  const auto c = [&](std::size_t term) { return hn::Set(d, surface.local[term]); };
  Exact<V> sum{c(Form::one), hn::Set(d, surface.local_low[Form::one])};
  const auto add = [&](std::size_t term, const Exact<V>& factor) {
    if (surface.local[term] == 0) return;
    sum = sum_of(sum, product_of(d, Exact<V>{c(term), hn::Set(d, surface.local_low[term])}, factor));
  };
  for (std::size_t axis = 0; axis < 3; ++axis) add(Form::x + axis, q[axis]);
  Triples<V> gradient{c(Form::x), c(Form::y), c(Form::z)};
  if (!surface.is_plane) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (surface.local[Form::xx + axis] != 0) add(Form::xx + axis, product_of(d, q[axis], q[axis]));
    }
    const V two = hn::Set(d, 2.0);
    gradient.x = hn::MulAdd(hn::Mul(two, c(Form::xx)), q[0].high, gradient.x);
    gradient.y = hn::MulAdd(hn::Mul(two, c(Form::yy)), q[1].high, gradient.y);
    gradient.z = hn::MulAdd(hn::Mul(two, c(Form::zz)), q[2].high, gradient.z);
    if (surface.is_mixed) {
      add(Form::xy, product_of(d, q[0], q[1]));
      add(Form::xz, product_of(d, q[0], q[2]));
      add(Form::yz, product_of(d, q[1], q[2]));
      const V xy = c(Form::xy), xz = c(Form::xz), yz = c(Form::yz);
      gradient.x = hn::MulAdd(xy, q[1].high, hn::MulAdd(xz, q[2].high, gradient.x));
      gradient.y = hn::MulAdd(xy, q[0].high, hn::MulAdd(yz, q[2].high, gradient.y));
      gradient.z = hn::MulAdd(xz, q[0].high, hn::MulAdd(yz, q[1].high, gradient.z));
    }
  }
  const V size = hn::Max(hn::Max(hn::Abs(q[0].high), hn::Abs(q[1].high)), hn::Max(hn::Abs(q[2].high), zero));
  return {sum, fused_dot(gradient, line.direction), size};
}

/// The t of the crossing near tau, rounded to nearest, and the lanes in which it is certain.
template <class D>
HWY_INLINE hn::Mask<D> nearest_t_lanes(D d, const LineLanes<D>& line, const Surface& surface, hn::Vec<D> tau,
                                       hn::Vec<D>& t) {
  using V = hn::Vec<D>;
  constexpr double u = 0x1p-53;
  constexpr double uu = 0x1p-106;
  const auto set = [&](double value) { return hn::Set(d, value); };
  const Residual<D> f = residual_at(d, line, surface, tau);
  const V step = hn::Neg(hn::Div(f.value.high, f.slope));
  // The bounds are those of nearest_t.cpp; |direction| < 2 on each axis.
  const V bend = set(surface.second_degree);
  const V first = set(surface.first_degree);
  const V steepness = hn::MulAdd(hn::Mul(set(2.0), bend), f.size, first);
  const V reach = hn::MulAdd(set(2.0), hn::Abs(tau), hn::Add(longest(line.near), set(longest(surface.center))));
  const V off = hn::MulAdd(set(16 * uu), reach, line.low_error);
  const V magnitude = hn::MulAdd(hn::MulAdd(bend, f.size, first), f.size, set(surface.constant));
  const V value_error = hn::MulAdd(set(64 * uu), magnitude, hn::Mul(steepness, off));
  const V slope_error = hn::Mul(set(16 * u), steepness);
  const V size = hn::Abs(f.slope);
  const V curvature = hn::Mul(hn::Mul(set(4.0), bend), hn::Mul(step, step));
  const V sum = hn::Add(hn::Add(value_error, curvature),
                        hn::MulAdd(hn::Abs(step), slope_error, hn::Mul(set(4 * u), hn::Abs(f.value.high))));
  const V error = hn::Div(hn::Mul(set(2.0), sum), size);

  const Exact<V> base = two_sum(line.shift, tau);
  const Exact<V> moved = two_sum(base.high, step);
  const V low = hn::Add(base.low, moved.low);
  const V slack = hn::Add(hn::MulAdd(set(2 * u), hn::Abs(low), error), set(0x1p-1000));
  const V below = hn::Add(moved.high, hn::Sub(low, slack));
  const V above = hn::Add(moved.high, hn::Add(low, slack));
  t = hn::Mul(below, line.unit);
  const V t_size = hn::Abs(t);
  // Subnormal and infinite numbers are excluded.
  const auto scales =
      hn::Or(hn::And(hn::Gt(t_size, set(0x1p-1000)), hn::Lt(t_size, set(0x1p1000))), hn::Eq(t, hn::Zero(d)));
  const auto is_steep = hn::Lt(hn::Mul(set(4.0), slope_error), size);
  return hn::And(hn::And(hn::Eq(below, above), scales), is_steep);
}

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
