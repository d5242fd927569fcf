// SPDX-License-Identifier: MIT
// The operations on lanes that csgcast uses. They are Highway's, and the same operations on plain numbers, so that
// packets and single rays share one formula. The file is included once for each instruction set, by files that include
// themselves (hwy/foreach_target.h).
#if defined(CSGCAST_LANE_OPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_OPS_INL_H
#undef CSGCAST_LANE_OPS_INL_H
#else
#define CSGCAST_LANE_OPS_INL_H
#endif

#include <hwy/highway.h>

#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "csg/base/precondition.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast {
namespace HWY_NAMESPACE {
namespace ops {
namespace hh = hwy::HWY_NAMESPACE;

/// The tag for one lane that is a plain number and no register. Its mask is a bool.
template <class Number>
struct Single {
  using T = Number;
};

template <class D>
constexpr bool is_single = false;
template <class Number>
constexpr bool is_single<Single<Number>> = true;

template <class D>
struct TypesOf {
  using Vec = hh::Vec<D>;
  using Mask = hh::Mask<D>;
  using Unsigned = hh::RebindToUnsigned<D>;
  using Signed = hh::RebindToSigned<D>;
  template <class T>
  using Rebind = hh::Rebind<T, D>;
};

template <class Number>
struct TypesOf<Single<Number>> {
  using Vec = Number;
  using Mask = bool;
  using Unsigned = Single<std::uint64_t>;
  using Signed = Single<std::int64_t>;
  template <class T>
  using Rebind = Single<T>;
};

template <class D>
using Vec = typename TypesOf<D>::Vec;
template <class D>
using Mask = typename TypesOf<D>::Mask;
template <class D>
using RebindToUnsigned = typename TypesOf<D>::Unsigned;
template <class D>
using RebindToSigned = typename TypesOf<D>::Signed;
template <class T, class D>
using Rebind = typename TypesOf<D>::template Rebind<T>;

using hh::Abs;
using hh::Add;
using hh::AllFalse;
using hh::And;
using hh::AndNot;
using hh::BitCast;
using hh::CappedTag;
using hh::ConvertTo;
using hh::Div;
using hh::Eq;
using hh::FindFirstTrue;
using hh::FirstN;
using hh::GatherOffset;
using hh::Ge;
using hh::Gt;
using hh::IfThenElse;
using hh::IfThenElseZero;
using hh::IfThenZeroElse;
using hh::Inf;
using hh::Lanes;
using hh::Le;
using hh::Load;
using hh::LoadMaskBits;
using hh::LoadU;
using hh::Lt;
using hh::MaskFromVec;
using hh::Max;
using hh::Min;
using hh::Mul;
using hh::MulAdd;
using hh::MulSub;
using hh::Ne;
using hh::Neg;
using hh::Not;
using hh::Or;
using hh::PromoteTo;
using hh::RebindMask;
using hh::Set;
using hh::ShiftLeft;
using hh::ShiftRight;
using hh::Shr;
using hh::Sqrt;
using hh::Store;
using hh::StoreMaskBits;
using hh::StoreU;
using hh::Sub;
using hh::TruncateTo;
using hh::Xor;
using hh::Zero;

// From here on the operations are on single numbers.

template <class T>
concept Number = std::same_as<T, double> || std::same_as<T, std::uint64_t> || std::same_as<T, std::int64_t> ||
    std::same_as<T, std::uint32_t>;

template <class T>
constexpr std::size_t Lanes(Single<T>) {
  return 1;
}

template <class T>
HWY_INLINE T Set(Single<T>, std::type_identity_t<T> x) {
  return x;
}
template <class T>
HWY_INLINE T Zero(Single<T>) {
  return 0;
}
HWY_INLINE double Inf(Single<double>) { return std::numeric_limits<double>::infinity(); }

HWY_INLINE double Add(double a, double b) { return a + b; }
HWY_INLINE double Sub(double a, double b) { return a - b; }
HWY_INLINE double Mul(double a, double b) { return a * b; }
HWY_INLINE double Div(double a, double b) { return a / b; }
HWY_INLINE double Neg(double a) { return -a; }
HWY_INLINE double Abs(double a) { return std::fabs(a); }
/// As on x86, the result is b if either operand is NaN.
HWY_INLINE double Max(double a, double b) { return a > b ? a : b; }
HWY_INLINE double Min(double a, double b) { return a < b ? a : b; }
/// A square root without the library's error handling.
HWY_INLINE double Sqrt(double a) {
  const hh::CappedTag<double, 1> d;
  return hh::GetLane(hh::Sqrt(hh::Set(d, a)));
}
#if HWY_NATIVE_FMA
HWY_INLINE double MulAdd(double a, double b, double c) { return __builtin_fma(a, b, c); }
HWY_INLINE double MulSub(double a, double b, double c) { return __builtin_fma(a, b, -c); }
#else
HWY_INLINE double MulAdd(double a, double b, double c) { return a * b + c; }
HWY_INLINE double MulSub(double a, double b, double c) { return a * b - c; }
#endif

HWY_INLINE double Xor(double a, double b) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(a) ^ std::bit_cast<std::uint64_t>(b));
}

HWY_INLINE std::uint64_t Add(std::uint64_t a, std::uint64_t b) { return a + b; }
HWY_INLINE std::uint64_t Sub(std::uint64_t a, std::uint64_t b) { return a - b; }
HWY_INLINE std::uint64_t And(std::uint64_t a, std::uint64_t b) { return a & b; }
HWY_INLINE std::uint64_t AndNot(std::uint64_t a, std::uint64_t b) { return ~a & b; }
HWY_INLINE std::uint64_t Or(std::uint64_t a, std::uint64_t b) { return a | b; }
HWY_INLINE std::uint64_t Xor(std::uint64_t a, std::uint64_t b) { return a ^ b; }
/// Precondition: by < 64.
HWY_INLINE std::uint64_t Shr(std::uint64_t a, std::uint64_t by) {
  CSGCAST_PRECONDITION(by < 64);
  return a >> by;
}
template <int by>
HWY_INLINE std::uint64_t ShiftLeft(std::uint64_t a) {
  return a << by;
}
template <int by>
HWY_INLINE std::uint64_t ShiftRight(std::uint64_t a) {
  return a >> by;
}

template <Number T>
HWY_INLINE bool Eq(T a, T b) {
  return a == b;
}
template <Number T>
HWY_INLINE bool Ne(T a, T b) {
  return a != b;
}
HWY_INLINE bool Lt(double a, double b) { return a < b; }
HWY_INLINE bool Le(double a, double b) { return a <= b; }
HWY_INLINE bool Gt(double a, double b) { return a > b; }
HWY_INLINE bool Ge(double a, double b) { return a >= b; }

HWY_INLINE bool And(bool a, bool b) { return a & b; }
HWY_INLINE bool Or(bool a, bool b) { return a | b; }
HWY_INLINE bool Xor(bool a, bool b) { return a != b; }
HWY_INLINE bool AndNot(bool a, bool b) { return !a & b; }
HWY_INLINE bool Not(bool a) { return !a; }
template <class T>
HWY_INLINE bool AllFalse(Single<T>, bool a) {
  return !a;
}
template <class T>
HWY_INLINE std::size_t FindFirstTrue(Single<T>, bool) {
  return 0;
}
template <class T>
HWY_INLINE bool FirstN(Single<T>, std::size_t n) {
  return n > 0;
}
template <Number T>
HWY_INLINE bool MaskFromVec(T a) {
  return std::bit_cast<std::uint64_t>(a) != 0;
}
template <class T>
HWY_INLINE bool RebindMask(Single<T>, bool a) {
  return a;
}
template <class T>
HWY_INLINE std::size_t StoreMaskBits(Single<T>, bool a, std::uint8_t* to) {
  *to = a ? 1 : 0;
  return 1;
}
template <class T>
HWY_INLINE bool LoadMaskBits(Single<T>, const std::uint8_t* from) {
  return (*from & 1) != 0;
}

template <Number T>
HWY_INLINE T IfThenElse(bool which, T yes, T no) {
  return which ? yes : no;
}
template <Number T>
HWY_INLINE T IfThenElseZero(bool which, T yes) {
  return which ? yes : T{0};
}
template <Number T>
HWY_INLINE T IfThenZeroElse(bool which, T no) {
  return which ? T{0} : no;
}

template <class To, Number T>
HWY_INLINE To BitCast(Single<To>, T a) {
  return std::bit_cast<To>(a);
}
HWY_INLINE double ConvertTo(Single<double>, std::int64_t a) { return static_cast<double>(a); }
HWY_INLINE std::uint64_t PromoteTo(Single<std::uint64_t>, std::uint32_t a) { return a; }
HWY_INLINE std::uint32_t TruncateTo(Single<std::uint32_t>, std::uint64_t a) { return static_cast<std::uint32_t>(a); }

template <class T>
HWY_INLINE T Load(Single<T>, const T* from) {
  return *from;
}
template <class T>
HWY_INLINE T LoadU(Single<T>, const T* from) {
  return *from;
}
template <class T>
HWY_INLINE void Store(T a, Single<T>, T* to) {
  *to = a;
}
template <class T>
HWY_INLINE void StoreU(T a, Single<T>, T* to) {
  *to = a;
}
/// `offset` is in bytes.
HWY_INLINE std::uint64_t GatherOffset(Single<std::uint64_t>, const std::uint64_t* from, std::int64_t offset) {
  return from[offset / 8];
}

}  // namespace ops
}  // namespace HWY_NAMESPACE
}  // namespace csgcast
HWY_AFTER_NAMESPACE();
#endif
