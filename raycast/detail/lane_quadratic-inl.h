// SPDX-License-Identifier: MIT
// A quadric along lines, a line a lane. Compiled once for each instruction set; included by lanes.cpp only.
#if defined(CSGCAST_LANE_QUADRATIC_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_QUADRATIC_INL_H
#undef CSGCAST_LANE_QUADRATIC_INL_H
#else
#define CSGCAST_LANE_QUADRATIC_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

/// f = a s² + 2 b s + c about the closest approach to the center, at tau = origin; the operations of quadric_line.h,
/// but for sums with terms that are zero.
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

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
