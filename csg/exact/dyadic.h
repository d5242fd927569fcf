// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>

#include <gmpxx.h>

namespace csgcast {

/// An exact number m * 2^e with integers m and e: what sums and products of doubles are.
///
/// Kept normalised: m is odd, or zero with e = 0, so equality is equality of the two members.
class Dyadic {
 public:
  Dyadic() = default;
  /// Exact. Precondition: value is finite.
  Dyadic(double value);  // NOLINT(google-explicit-constructor): a double is a dyadic number
  /// mantissa * 2^exponent.
  Dyadic(mpz_class mantissa, std::int64_t exponent);

  /// -1, 0 or 1.
  int sign() const { return sgn(mantissa_); }
  bool is_zero() const { return sign() == 0; }
  const mpz_class& mantissa() const { return mantissa_; }
  std::int64_t exponent() const { return exponent_; }
  /// The number of bits of |m|; 0 for zero.
  std::size_t bits() const;
  /// The least k with |value| < 2^k; meaningless for zero.
  std::int64_t magnitude() const { return static_cast<std::int64_t>(bits()) + exponent_; }
  /// value * 2^shift.
  Dyadic scaled(std::int64_t shift) const;

  Dyadic operator-() const;
  Dyadic& operator+=(const Dyadic& other);
  Dyadic& operator-=(const Dyadic& other);
  Dyadic& operator*=(const Dyadic& other);
  friend Dyadic operator+(Dyadic a, const Dyadic& b) { return a += b; }
  friend Dyadic operator-(Dyadic a, const Dyadic& b) { return a -= b; }
  friend Dyadic operator*(Dyadic a, const Dyadic& b) { return a *= b; }
  friend bool operator==(const Dyadic& a, const Dyadic& b) {
    return a.exponent_ == b.exponent_ && a.mantissa_ == b.mantissa_;
  }
  friend std::strong_ordering operator<=>(const Dyadic& a, const Dyadic& b);

  /// The nearest double, ties to even; overflows to infinity, gradual underflow.
  double nearest() const;
  /// The largest double <= value (-infinity possible).
  double rounded_down() const;
  /// The least double >= value (+infinity possible).
  double rounded_up() const;

 private:
  void normalise();

  mpz_class mantissa_ = 0;
  std::int64_t exponent_ = 0;
};

}  // namespace csgcast
