// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace csgcast::detail {

/// An unevaluated sum high + low of two doubles, |low| <= ulp(high) / 2.
struct Twofold {
  double high = 0;
  double low = 0;
};

/// a + b exactly, barring overflow.  Source: Knuth, TAOCP 2, 4.2.2.
inline Twofold two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

/// a + b exactly if |a| >= |b| or a = 0.  Source: Dekker 1971.
inline Twofold fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a b exactly, barring overflow and underflow of the low part. This is the one place that asks for a fused
/// multiply-add, and it does so by name.
inline Twofold two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

inline Twofold operator-(Twofold a) { return {-a.high, -a.low}; }

// Sums and products of twofold numbers. With u = 2^-53 the relative errors are below 3u² + 13u³ (sum), 7u² (product)
// and 2u² (by a double). Source: Joldes, Muller and Popescu 2017, Tight and rigorous error bounds for basic building
// blocks of double-word arithmetic: AccurateDWPlusDW, DWTimesDW1, DWTimesFP1.

inline Twofold operator+(Twofold a, Twofold b) {
  const Twofold high = two_sum(a.high, b.high);
  const Twofold low = two_sum(a.low, b.low);
  const Twofold sum = fast_two_sum(high.high, high.low + low.high);
  return fast_two_sum(sum.high, low.low + sum.low);
}

inline Twofold operator*(Twofold a, Twofold b) {
  const Twofold high = two_product(a.high, b.high);
  const double cross = a.high * b.low + a.low * b.high;
  return fast_two_sum(high.high, high.low + cross);
}

inline Twofold operator*(Twofold a, double b) {
  const Twofold high = two_product(a.high, b);
  const Twofold sum = fast_two_sum(high.high, a.low * b);
  return fast_two_sum(sum.high, sum.low + high.low);
}

}  // namespace csgcast::detail
