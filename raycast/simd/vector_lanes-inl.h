// SPDX-License-Identifier: MIT
// The functions of csg/base/vector.h and length.h in the lanes of vector registers. They do the same operations in the
// same order, so the numbers are the same, bit for bit. The file is included once for each instruction set, by files
// that include themselves (hwy/foreach_target.h).
#if defined(CSGCAST_VECTOR_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_VECTOR_LANES_INL_H
#undef CSGCAST_VECTOR_LANES_INL_H
#else
#define CSGCAST_VECTOR_LANES_INL_H
#endif

#include <hwy/highway.h>

#include "raycast/simd/lane_ops-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast {
namespace HWY_NAMESPACE {
namespace hn = ops;

template <class D>
using BitsOf = hn::RebindToUnsigned<D>;

/// A vector, point or normal in each lane.
template <class V>
struct Triples {
  V x, y, z;
};

template <class V>
HWY_INLINE Triples<V> operator+(const Triples<V>& a, const Triples<V>& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

template <class V>
HWY_INLINE Triples<V> operator-(const Triples<V>& a, const Triples<V>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

template <class V>
HWY_INLINE Triples<V> operator-(const Triples<V>& a) {
  return {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)};
}

template <class V>
HWY_INLINE Triples<V> scaled_by(V s, const Triples<V>& a) {
  return {hn::Mul(s, a.x), hn::Mul(s, a.y), hn::Mul(s, a.z)};
}

template <class V>
HWY_INLINE V dot(const Triples<V>& a, const Triples<V>& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

template <class V>
HWY_INLINE V longest(const Triples<V>& a) {
  return hn::Max(hn::Max(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
}

/// Selects `yes` where the mask is set.
template <class M, class V>
HWY_INLINE Triples<V> choose(M mask, const Triples<V>& yes, const Triples<V>& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}

/// The same vector in every lane.
template <class D, class T>
HWY_INLINE Triples<hn::Vec<D>> in_all_lanes(D d, const T& v) {
  return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

template <class D>
HWY_INLINE hn::Vec<BitsOf<D>> biased_exponent(D, hn::Vec<D> v) {
  const BitsOf<D> bits;
  return hn::And(hn::ShiftRight<52>(hn::BitCast(bits, v)), hn::Set(bits, 0x7ffu));
}

/// Computes 2^(n - 1023), if the result is a normal number.
template <class D>
HWY_INLINE hn::Vec<D> power_of_biased(D d, hn::Vec<BitsOf<D>> n) {
  return hn::BitCast(d, hn::ShiftLeft<52>(n));
}

/// As normalised(), but also zero if a vector is longer than 2^1000 or shorter than 2^-1000.
template <class D>
HWY_INLINE Triples<hn::Vec<D>> normalised_lanes(D d, const Triples<hn::Vec<D>>& v) {
  using V = hn::Vec<D>;
  const BitsOf<D> bits;
  const V largest = longest(v);
  const V scale = power_of_biased(d, hn::Sub(hn::Set(bits, 2046u), biased_exponent(d, largest)));
  const Triples<V> scaled = scaled_by(scale, v);
  const V inverse = hn::Div(hn::Set(d, 1.0), hn::Sqrt(dot(scaled, scaled)));
  const auto usable = hn::And(hn::Gt(largest, hn::Set(d, 0x1p-1000)), hn::Lt(largest, hn::Set(d, 0x1p1000)));
  const auto result = [&](V s) { return hn::IfThenElseZero(usable, hn::Mul(inverse, s)); };
  return {result(scaled.x), result(scaled.y), result(scaled.z)};
}

template <class D>
HWY_INLINE void store_lanes(D d, hn::Vec<D> v, double* to, std::size_t count) {
  if (count >= hn::Lanes(d)) return hn::StoreU(v, d, to);
  HWY_ALIGN double buffer[16];
  hn::Store(v, d, buffer);
  for (std::size_t i = 0; i < count; ++i) to[i] = buffer[i];
}

/// Loads the numbers for the lanes of a register from memory. Lanes from `count` on (which is above 0) repeat the last
/// number.
template <class D>
HWY_INLINE hn::Vec<D> load_lanes(D d, const double* from, std::size_t count) {
  const std::size_t lanes = hn::Lanes(d);
  if (count >= lanes) return hn::LoadU(d, from);
  HWY_ALIGN double buffer[16];
  for (std::size_t i = 0; i < lanes; ++i) buffer[i] = from[i < count ? i : count - 1];
  return hn::Load(d, buffer);
}

template <class D>
HWY_INLINE void store_lanes(D d, const Triples<hn::Vec<D>>& v, double* const* to, std::size_t first,
                            std::size_t count) {
  store_lanes(d, v.x, to[0] + first, count);
  store_lanes(d, v.y, to[1] + first, count);
  store_lanes(d, v.z, to[2] + first, count);
}

template <class D, class Pointer>
HWY_INLINE Triples<hn::Vec<D>> load_lanes(D d, const Pointer* from, std::size_t first, std::size_t count) {
  return {load_lanes(d, from[0] + first, count), load_lanes(d, from[1] + first, count),
          load_lanes(d, from[2] + first, count)};
}

}  // namespace HWY_NAMESPACE
}  // namespace csgcast
HWY_AFTER_NAMESPACE();
#endif
