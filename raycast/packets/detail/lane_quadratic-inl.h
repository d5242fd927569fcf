// SPDX-License-Identifier: MIT
// Computes a quadric along lines, with a line in each lane, and where the lines cross it. Compiled once for each
// instruction set, by lanes.cpp.
#if defined(CSGCAST_LANE_QUADRATIC_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_QUADRATIC_INL_H
#undef CSGCAST_LANE_QUADRATIC_INL_H
#else
#define CSGCAST_LANE_QUADRATIC_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "csg/exact/quadric_form.h"
#include "raycast/cells/build/cell_data.h"
#include "raycast/packets/detail/lane_events-inl.h"
#include "raycast/packets/detail/lane_line-inl.h"
#include "raycast/surface/surface.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

/// f = a s² + 2 b s + c about the closest approach to the center, at tau = origin. The operations are those of
/// quadric_line.cpp, without sums of terms that are zero.
template <class D>
struct QuadraticLanes {
  using V = hn::Vec<D>;
  V a, b, c, origin;
  Triples<V> start, q;
};

template <class D>
HWY_INLINE QuadraticLanes<D> quadratic(D d, const LineLanes<D>& line, const Surface& surface) {
  const Surface::Coefficients& k = surface.local;
  const Vector& center = surface.center;
  using V = hn::Vec<D>;
  using Form = QuadricForm;
  const auto c = [&](std::size_t term) { return hn::Set(d, k[term]); };
  const V half = hn::Set(d, 0.5);
  const auto times_matrix = [&](const Triples<V>& v) {
    const auto row = [&](Form::Term own, V x, Form::Term m1, V y, Form::Term m2, V z) {
      return hn::Add(hn::Mul(c(own), x), hn::Mul(half, hn::Add(hn::Mul(c(m1), y), hn::Mul(c(m2), z))));
    };
    if (!surface.is_mixed)
      return Triples<V>{hn::Mul(c(Form::xx), v.x), hn::Mul(c(Form::yy), v.y), hn::Mul(c(Form::zz), v.z)};
    return Triples<V>{row(Form::xx, v.x, Form::xy, v.y, Form::xz, v.z),
                      row(Form::yy, v.y, Form::xy, v.x, Form::yz, v.z),
                      row(Form::zz, v.z, Form::xz, v.x, Form::yz, v.y)};
  };
  QuadraticLanes<D> f;
  f.start = {hn::Sub(line.near.x, hn::Set(d, center.x)), hn::Sub(line.near.y, hn::Set(d, center.y)),
             hn::Sub(line.near.z, hn::Set(d, center.z))};
  f.origin = hn::Mul(hn::Neg(dot(f.start, line.direction)), line.inverse_squared);
  f.q = {hn::Add(f.start.x, hn::Mul(f.origin, line.direction.x)),
         hn::Add(f.start.y, hn::Mul(f.origin, line.direction.y)),
         hn::Add(f.start.z, hn::Mul(f.origin, line.direction.z))};
  const Triples<V> linear{c(Form::x), c(Form::y), c(Form::z)};
  const Triples<V> image = times_matrix(line.direction);
  f.a = dot(line.direction, image);
  f.b = hn::Add(dot(f.q, image), hn::Mul(half, dot(linear, line.direction)));
  f.c = hn::Add(hn::Add(dot(f.q, times_matrix(f.q)), dot(linear, f.q)), c(Form::one));
  return f;
}

/// Computes root - b where b is below zero, and -(b + root) elsewhere, so that nothing cancels. The sign is
/// unpredictable, so there is no branch.
template <class D>
HWY_INLINE hn::Vec<D> far_sum(D d, hn::Vec<D> b, hn::Vec<D> root) {
  const hn::Vec<D> flip = hn::IfThenElseZero(hn::Lt(b, hn::Zero(d)), hn::Set(d, -0.0));
  return hn::Neg(hn::Add(b, hn::Xor(root, flip)));
}

/// Any quadric, with running errors, as in quadric_line.cpp.
template <class D>
HWY_INLINE void quadric_events(D d, const LineLanes<D>& line, const Surface& quadric, hn::Mask<D> departing,
                               const Departures<D>* departures, std::size_t i, Events<D>& events) {
  using V = hn::Vec<D>;
  const QuadraticLanes<D> f = quadratic(d, line, quadric);
  const auto set = [&](double value) { return hn::Set(d, value); };
  constexpr double u = 0x1p-53 * (1 + 0x1p-20);  // slightly enlarged, to cover the rounding of the bounds
  const V size = longest(f.q);
  const V e = set(2.0);
  const V off = hn::MulAdd(set(u), hn::MulAdd(set(3.0), longest(f.start), size), hn::Mul(line.near_error, set(1.001)));
  const V bend = set(quadric.second_degree);
  const V slope = hn::MulAdd(bend, size, set(quadric.first_degree));
  const V error_a = set(32 * u * quadric.second_degree);
  const V error_b = hn::Mul(hn::MulAdd(set(9 * u), slope, hn::Mul(bend, off)), e);
  const V value_size = hn::MulAdd(slope, size, set(quadric.constant));
  const V error_c =
      hn::MulAdd(hn::Add(hn::MulAdd(bend, size, slope), hn::Mul(bend, off)), off, hn::Mul(set(11 * u), value_size));
  const V abs_a = hn::Abs(f.a), abs_b = hn::Abs(f.b), abs_c = hn::Abs(f.c);
  const V bb = hn::Mul(f.b, f.b);
  const V ac = hn::Mul(f.a, f.c);
  const V discriminant = hn::Sub(bb, ac);
  const V d_error =
      hn::Add(hn::Add(hn::Mul(hn::MulAdd(set(2.0), abs_b, error_b), error_b), hn::Mul(abs_a, error_c)),
              hn::MulAdd(error_a, hn::Add(abs_c, error_c), hn::Mul(set(3 * u), hn::Add(bb, hn::Abs(ac)))));
  const V zero = hn::Zero(d);
  const V safe = hn::Max(discriminant, d_error);
  const V root = hn::Sqrt(safe);
  const auto falls = hn::Lt(f.b, zero);
  const V sum = far_sum(d, f.b, root);
  const V abs_sum = hn::Abs(sum);
  // One division serves three inverses; each is off by 5 u.
  const V tiny = set(1e-100);
  const V safe_a = hn::IfThenElse(hn::Lt(hn::Abs(f.a), tiny), tiny, f.a);
  const V a_root = hn::Mul(safe_a, root);
  const V sum_root = hn::Mul(sum, root);
  const V inverse = hn::Div(set(1.0), hn::Mul(sum, a_root));
  const V inverse_sum = hn::Mul(a_root, inverse);
  const V inverse_a = hn::Mul(sum_root, inverse);
  const V inverse_root = hn::Abs(hn::Mul(hn::Mul(safe_a, sum), inverse));
  const V sum_error = hn::Add(error_b, hn::MulAdd(set(2 * u), abs_sum, hn::Mul(d_error, inverse_root)));
  const V at_near = hn::Mul(f.c, inverse_sum);
  const V at_far = hn::Mul(sum, inverse_a);
  const V near_off = hn::Mul(hn::MulAdd(hn::Abs(at_near), sum_error, error_c), hn::Abs(inverse_sum));
  const V far_off = hn::Mul(hn::MulAdd(hn::Abs(at_far), error_a, sum_error), hn::Abs(inverse_a));
  // Nothing beyond 4 from the closest approach can matter.
  const V reach = set(4.0);
  const auto far_is_out = hn::Gt(hn::Sub(abs_sum, sum_error), hn::Mul(set(4.01), hn::Add(abs_a, error_a)));
  // Four times twice the first-order errors of the quotients. The roundings of origin and of sums are below 16 u each.
  const V spread = hn::Max(near_off, hn::IfThenZeroElse(far_is_out, far_off));
  const V slack = hn::MulAdd(set(8.0), spread, set(256 * u));
  const auto none_in_reach = hn::Gt(
      hn::Sub(abs_c, error_c),
      hn::Mul(hn::Mul(hn::MulAdd(hn::Add(abs_a, error_a), reach, hn::Mul(set(2.0), hn::Add(abs_b, error_b))), reach),
              set(1.001)));
  const auto surely_misses = hn::And(hn::Lt(discriminant, hn::Neg(d_error)),
                                     hn::Gt(hn::Max(hn::Sub(abs_a, error_a), hn::Sub(abs_c, error_c)), zero));
  const auto has_none = hn::Or(surely_misses, none_in_reach);
  const auto is_sound = hn::And(
      hn::And(hn::Gt(discriminant, d_error), hn::Gt(abs_sum, hn::Mul(set(2.0), sum_error))),
      hn::And(hn::Le(slack, set(greatest_slack)), hn::Or(far_is_out, hn::Gt(abs_a, hn::Mul(set(2.0), error_a)))));
  const V never = hn::Inf(d);
  const V near_tau = hn::Add(f.origin, at_near);
  const V far_tau = hn::Add(f.origin, at_far);
  const V lower = hn::IfThenElse(far_is_out, near_tau, hn::Min(near_tau, far_tau));
  const V upper = hn::IfThenElse(far_is_out, never, hn::Max(near_tau, far_tau));
  events.first[i] = hn::IfThenElse(has_none, never, lower);
  events.second[i] = hn::IfThenElse(has_none, never, upper);
  const auto a_is_positive = hn::Gt(f.a, zero);
  const auto c_is_positive = hn::Gt(f.c, zero);
  const auto certain_a = hn::Gt(abs_a, error_a);
  const auto sign_of_none = hn::Or(hn::And(hn::AndNot(none_in_reach, certain_a), a_is_positive),
                                   hn::AndNot(hn::AndNot(none_in_reach, certain_a), c_is_positive));
  const auto two = hn::Or(hn::And(far_is_out, falls), hn::AndNot(far_is_out, a_is_positive));
  const auto positive_before = hn::Or(hn::And(has_none, sign_of_none), hn::AndNot(has_none, two));
  const auto is_open = hn::AndNot(has_none, hn::Not(is_sound));
  if (departures == nullptr) {
    set_before(events, i, positive_before);
    widen(events, hn::IfThenElseZero(hn::AndNot(has_none, is_sound), slack));
    return flag(events, is_open);
  }
  widen(events, hn::IfThenElseZero(hn::AndNot(departing, hn::AndNot(has_none, is_sound)), slack));
  flag(events, hn::AndNot(departing, is_open));
  // f' = 2 b at the closest approach. The two roots lie equally far on either side of -b / a from there.
  const V ratio = hn::Mul(f.b, inverse_a);
  const V middle = hn::Sub(f.origin, ratio);
  const V other = hn::Sub(hn::Add(middle, middle), line.start);
  const V ratio_off = hn::Mul(hn::MulAdd(hn::Abs(ratio), error_a, error_b), hn::Abs(inverse_a));
  const V other_slack = hn::MulAdd(set(16.0), ratio_off, set(1024 * u));
  const auto leaves =
      hn::Or(hn::And(a_is_positive, departures->positive), hn::AndNot(a_is_positive, hn::Not(departures->positive)));
  const auto comes_back = hn::AndNot(leaves, departing);
  const V gap = hn::Sub(other, line.start);
  const auto too_near = hn::Or(hn::Gt(other_slack, set(greatest_slack)), hn::Lt(gap, set(2 * greatest_slack)));
  flag(events, hn::And(departing, hn::Not(certain_a)));
  flag(events, hn::And(comes_back, too_near));
  flag(events, hn::And(hn::And(departing, leaves), hn::Gt(gap, set(2 * greatest_slack))));
  widen(events, hn::IfThenElseZero(comes_back, other_slack));
  const V before = hn::Neg(never);
  events.first[i] = hn::IfThenElse(departing, before, events.first[i]);
  events.second[i] = hn::IfThenElse(departing, hn::IfThenElse(leaves, before, other), events.second[i]);
  set_before(events, i, hn::Or(hn::And(departing, a_is_positive), hn::AndNot(departing, positive_before)));
}

/// A quadric about a line along an axis that is neither a sphere nor a cylinder. It needs few constants.
template <class D>
HWY_INLINE void revolved_events(D d, const LineLanes<D>& line, const Slot& quadric, std::size_t axis, std::size_t i,
                                Events<D>& events) {
  using V = hn::Vec<D>;
  const V near[3] = {line.near.x, line.near.y, line.near.z};
  const V along[3] = {line.direction.x, line.direction.y, line.direction.z};
  const auto set = [&](double value) { return hn::Set(d, value); };
  const auto of_three = [&](auto&& part) { return Triples<V>{part((axis + 1) % 3), part((axis + 2) % 3), part(axis)}; };
  // The order is: across the axis first, then along it.
  const Triples<V> v = of_three([&](std::size_t k) { return hn::Sub(near[k], set(quadric.c[k])); });
  const Triples<V> e = of_three([&](std::size_t k) { return along[k]; });
  const V middle = hn::Mul(hn::Neg(fused_dot(v, e)), line.inverse_squared);
  const Triples<V> q{hn::MulAdd(middle, e.x, v.x), hn::MulAdd(middle, e.y, v.y), hn::MulAdd(middle, e.z, v.z)};
  // f = a s² + 2 b s + c about the point of the line that is nearest to the center.
  const V kappa = set(-quadric.c[3]);
  const V stretched_e = hn::Mul(kappa, e.z);
  const V a = hn::MulAdd(stretched_e, e.z, hn::MulAdd(e.x, e.x, hn::Mul(e.y, e.y)));
  const V b = hn::MulAdd(stretched_e, q.z, hn::MulAdd(q.x, e.x, hn::Mul(q.y, e.y)));
  const V c = hn::Sub(hn::MulAdd(hn::Mul(kappa, q.z), q.z, hn::MulAdd(q.x, q.x, hn::Mul(q.y, q.y))), set(quadric.c[4]));
  const V bb = hn::Mul(b, b);
  const V ac = hn::Mul(a, c);
  const V discriminant = hn::Sub(bb, ac);
  const V zero = hn::Zero(d);
  const V abs_a = hn::Abs(a);
  constexpr double u = 0x1p-53;
  const double unit = u * std::fmax(1, std::fabs(quadric.c[3]));
  const V off = hn::Abs(set(quadric.c[5]));  // the error of f, in the cell
  const V magnitude = hn::Add(bb, hn::Abs(ac));
  const V most_off = hn::MulAdd(hn::Mul(set(1.02), off), abs_a, hn::Mul(set(9 * u), magnitude));
  const auto has_none = hn::Lt(hn::Add(discriminant, most_off), zero);
  const V root = hn::Sqrt(hn::Max(discriminant, set(0x1p-200)));
  const auto falls = hn::Lt(b, zero);
  const V sum = far_sum(d, b, root);
  const V tiny = set(1e-100);
  const V safe_a = hn::IfThenElse(hn::Lt(abs_a, tiny), tiny, a);
  const V inverse = hn::Div(set(1.0), hn::Mul(sum, safe_a));
  const V at_near = hn::Mul(c, hn::Mul(safe_a, inverse));
  const V at_far = hn::Mul(sum, hn::Mul(sum, inverse));
  const auto far_is_out = hn::Gt(hn::Abs(sum), hn::Mul(set(4.01), hn::Add(abs_a, set(192 * unit))));
  // The error of a crossing is the error of f, divided by the slope there.
  const V least_root = hn::Max(hn::Mul(set(0x1p36), off), hn::Mul(set(0x1p-30), abs_a));
  const auto is_sound =
      hn::And(hn::And(hn::Gt(discriminant, hn::Mul(set(0x1p-13), magnitude)), hn::Ge(root, least_root)),
              hn::Or(far_is_out, hn::Gt(abs_a, set(256 * unit))));
  const V never = hn::Inf(d);
  const V near_tau = hn::Add(middle, at_near);
  const V far_tau = hn::Add(middle, at_far);
  const V lower = hn::IfThenElse(far_is_out, near_tau, hn::Min(near_tau, far_tau));
  const V upper = hn::IfThenElse(far_is_out, never, hn::Max(near_tau, far_tau));
  events.first[i] = hn::IfThenElse(has_none, never, lower);
  events.second[i] = hn::IfThenElse(has_none, never, upper);
  const auto before_two = hn::Or(hn::And(far_is_out, falls), hn::AndNot(far_is_out, hn::Gt(a, zero)));
  const auto before = hn::Or(hn::And(has_none, hn::Gt(c, zero)), hn::AndNot(has_none, before_two));
  set_before(events, i, quadric.c[5] > 0 ? before : hn::Not(before));
  flag(events, hn::AndNot(has_none, hn::Not(is_sound)));
}

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
