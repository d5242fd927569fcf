// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <gmpxx.h>

namespace csgcast {

/// An exact number m * 2^e with integers m and e. Sums and products of doubles are such numbers.
///
/// It is kept normalised: m is odd, or zero with e = 0. Mantissas below 2^127 are stored in the object itself, so the
/// first few sums and products of doubles allocate nothing. Larger mantissas are GMP's.
class Dyadic {
 public:
  Dyadic() = default;
  /// Exact. Precondition: value is finite.
  Dyadic(double value);  // NOLINT(google-explicit-constructor): a double is a dyadic number
  /// mantissa * 2^exponent.
  Dyadic(const mpz_class& mantissa, std::int64_t exponent);
  Dyadic(const Dyadic& other)
      : small_(other.small_),
        large_(other.large_ ? std::make_unique<mpz_class>(*other.large_) : nullptr),
        exponent_(other.exponent_) {}
  Dyadic(Dyadic&& other) noexcept = default;
  Dyadic& operator=(const Dyadic& other) {
    if (this != &other) *this = Dyadic(other);
    return *this;
  }
  Dyadic& operator=(Dyadic&& other) noexcept = default;
  ~Dyadic() = default;

  /// -1, 0 or 1.
  int sign() const { return large_ ? sgn(*large_) : (small_ > 0) - (small_ < 0); }
  bool is_zero() const { return !large_ && small_ == 0; }
  mpz_class mantissa() const;
  std::int64_t exponent() const { return exponent_; }
  /// The number of bits of |m|; 0 for zero.
  std::size_t bits() const { return large_ ? mpz_sizeinbase(large_->get_mpz_t(), 2) : bits_of(absolute(small_)); }
  /// The least k with |value| < 2^k; meaningless for zero.
  std::int64_t magnitude() const { return static_cast<std::int64_t>(bits()) + exponent_; }
  /// value * 2^shift.
  Dyadic scaled(std::int64_t shift) const& { return Dyadic(*this).scaled(shift); }
  Dyadic scaled(std::int64_t shift) && {
    if (!is_zero()) exponent_ += shift;
    return std::move(*this);
  }
  std::size_t hash() const;

  Dyadic operator-() const& { return -Dyadic(*this); }
  Dyadic operator-() && {
    if (large_) mpz_neg(large_->get_mpz_t(), large_->get_mpz_t());
    small_ = -small_;
    return std::move(*this);
  }
  Dyadic& operator+=(const Dyadic& other) { return other.is_zero() ? *this : *this = *this + other; }
  Dyadic& operator-=(const Dyadic& other) { return other.is_zero() ? *this : *this = *this - other; }
  Dyadic& operator*=(const Dyadic& other) { return *this = *this * other; }
  // Most terms of most forms and matrices are zero.
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    return a.is_zero() ? b : b.is_zero() ? a : sum(a, b, Sign::plus);
  }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) {
    return a.is_zero() ? -b : b.is_zero() ? a : sum(a, b, Sign::minus);
  }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    return a.is_zero() || b.is_zero() ? Dyadic() : product(a, b);
  }
  /// Appends the number's packed form. Equal numbers have equal bytes. unpack() is the inverse; it also advances to the
  /// bytes after the number.
  void pack(std::vector<std::byte>& bytes) const;
  static Dyadic unpack(const std::byte*& bytes);

  friend bool operator==(const Dyadic& a, const Dyadic& b);
  friend std::strong_ordering operator<=>(const Dyadic& a, const Dyadic& b);

  /// The greatest common divisor of the mantissas, an odd positive integer. If one number is zero, the other's
  /// mantissa.
  friend Dyadic common_divisor(const Dyadic& a, const Dyadic& b);
  /// a / b. Precondition: b's mantissa divides a's.
  friend Dyadic exact_quotient(const Dyadic& a, const Dyadic& b);

  /// The nearest double to value * 2^shift, ties to even. It overflows to infinity, and underflows gradually.
  double nearest(std::int64_t shift = 0) const;
  /// The largest double <= value (-infinity possible).
  double rounded_down() const;
  /// The least double >= value (+infinity possible).
  double rounded_up() const;

 private:
  __extension__ using Small = __int128;
  __extension__ using Bits = unsigned __int128;

  enum class Sign : std::uint8_t { plus, minus };
  class MantissaView;

  Dyadic(Small mantissa, std::int64_t exponent, std::nullptr_t);
  Dyadic(std::unique_ptr<mpz_class> mantissa, std::int64_t exponent);
  // Precondition: neither number is zero.
  static Dyadic sum(const Dyadic& a, const Dyadic& b, Sign sign_of_b);
  static Dyadic product(const Dyadic& a, const Dyadic& b);
  static Bits absolute(Small value) { return value < 0 ? -static_cast<Bits>(value) : static_cast<Bits>(value); }
  static std::size_t bits_of(Bits value) {
    const auto high = static_cast<std::uint64_t>(value >> 64);
    return static_cast<std::size_t>(high != 0 ? 64 + std::bit_width(high)
                                              : std::bit_width(static_cast<std::uint64_t>(value)));
  }
  static int trailing_zeros(Bits value) {
    const auto low = static_cast<std::uint64_t>(value);
    return low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<std::uint64_t>(value >> 64));
  }
  void normalise();

  Small small_ = 0;                   // the mantissa, unless large_ is set
  std::unique_ptr<mpz_class> large_;  // a mantissa of 128 bits or more
  std::int64_t exponent_ = 0;
};

}  // namespace csgcast
