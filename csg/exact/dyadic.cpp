// SPDX-License-Identifier: MIT
#include "csg/exact/dyadic.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace csgcast {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// |m| 2^e rounded toward zero to a double, and whether anything was cut off.
struct Truncated {
  double magnitude;
  bool exact;
  bool at_least_half;  // what was cut off is at least half a unit in the last place
  bool exactly_half;
};

Truncated truncate(const mpz_class& mantissa, std::int64_t exponent) {
  const auto bits = static_cast<std::int64_t>(mpz_sizeinbase(mantissa.get_mpz_t(), 2));
  if (bits + exponent > 1024) return {std::numeric_limits<double>::max(), false, true, false};
  // The unit in the last place of the result: 53 bits, or fewer for subnormal numbers.
  const std::int64_t unit = std::max<std::int64_t>(bits + exponent - 53, -1074);
  const std::int64_t cut = unit - exponent;
  if (cut <= 0) {
    mpz_class whole = abs(mantissa) << static_cast<mp_bitcnt_t>(-cut);
    return {std::ldexp(whole.get_d(), static_cast<int>(unit)), true, false, false};
  }
  if (cut > bits) return {0.0, false, false, false};
  const auto shift = static_cast<mp_bitcnt_t>(cut);
  const mpz_class all = abs(mantissa);
  const mpz_class kept = all >> shift;
  const bool half = mpz_tstbit(all.get_mpz_t(), shift - 1) != 0;
  const bool rest = mpz_scan1(all.get_mpz_t(), 0) < shift - 1;
  return {std::ldexp(kept.get_d(), static_cast<int>(unit)), !half && !rest, half, half && !rest};
}

bool is_odd_in_last_place(double magnitude) {
  if (magnitude == 0) return false;
  int exponent = 0;
  const double fraction = std::frexp(magnitude, &exponent);
  const int bits = std::min(53, exponent + 1074);  // subnormal numbers have fewer
  return std::fmod(std::ldexp(fraction, bits), 2.0) != 0;
}

}  // namespace

// A mantissa as GMP reads it, without a copy.
class Dyadic::MantissaView {
 public:
  explicit MantissaView(const Dyadic& number) {
    static_assert(sizeof(mp_limb_t) == sizeof(std::uint64_t));
    if (number.large_) {
      view_ = number.large_->get_mpz_t();
      return;
    }
    const Bits magnitude = absolute(number.small_);
    limbs_[0] = static_cast<std::uint64_t>(magnitude);
    limbs_[1] = static_cast<std::uint64_t>(magnitude >> 64);
    const mp_size_t count = limbs_[1] != 0 ? 2 : limbs_[0] != 0 ? 1 : 0;
    view_ = mpz_roinit_n(small_, limbs_, number.small_ < 0 ? -count : count);
  }
  MantissaView(const MantissaView&) = delete;
  MantissaView& operator=(const MantissaView&) = delete;

  operator mpz_srcptr() const { return view_; }  // NOLINT(google-explicit-constructor): what GMP's functions take

 private:
  mp_limb_t limbs_[2] = {0, 0};
  mpz_t small_{};
  mpz_srcptr view_ = nullptr;
};

Dyadic::Dyadic(double value) {
  if (value == 0) return;
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  small_ = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  exponent_ = exponent - 53;
  normalise();
}

Dyadic::Dyadic(const mpz_class& mantissa, std::int64_t exponent)
    : large_(std::make_unique<mpz_class>(mantissa)), exponent_(exponent) {
  normalise();
}

Dyadic::Dyadic(std::unique_ptr<mpz_class> mantissa, std::int64_t exponent)
    : large_(std::move(mantissa)), exponent_(exponent) {
  normalise();
}

Dyadic::Dyadic(Small mantissa, std::int64_t exponent, std::nullptr_t) : small_(mantissa), exponent_(exponent) {
  normalise();
}

Dyadic::Dyadic(const Dyadic& other)
    : small_(other.small_),
      large_(other.large_ ? std::make_unique<mpz_class>(*other.large_) : nullptr),
      exponent_(other.exponent_) {}

Dyadic& Dyadic::operator=(const Dyadic& other) {
  if (this != &other) *this = Dyadic(other);
  return *this;
}

void Dyadic::normalise() {
  if (large_) {
    const mp_bitcnt_t zeros = sgn(*large_) == 0 ? 0 : mpz_scan1(large_->get_mpz_t(), 0);
    if (zeros > 0) mpz_tdiv_q_2exp(large_->get_mpz_t(), large_->get_mpz_t(), zeros);
    exponent_ += static_cast<std::int64_t>(zeros);
    if (mpz_sizeinbase(large_->get_mpz_t(), 2) > 127) return;
    std::uint64_t words[2] = {0, 0};
    mpz_export(words, nullptr, -1, sizeof(std::uint64_t), 0, 0, large_->get_mpz_t());
    const Small magnitude = static_cast<Small>(static_cast<Bits>(words[1]) << 64 | words[0]);
    small_ = sgn(*large_) < 0 ? -magnitude : magnitude;
    large_.reset();
  }
  if (small_ == 0) {
    exponent_ = 0;
    return;
  }
  const auto low = static_cast<std::uint64_t>(small_);
  const int zeros = low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<std::uint64_t>(small_ >> 64));
  small_ >>= zeros;  // arithmetic, and exact: only zeros are cut off
  exponent_ += zeros;
}

mpz_class Dyadic::mantissa() const {
  mpz_class result;
  mpz_set(result.get_mpz_t(), MantissaView(*this));
  return result;
}

std::size_t Dyadic::bits() const {
  if (large_) return mpz_sizeinbase(large_->get_mpz_t(), 2);
  const Bits magnitude = absolute(small_);
  const auto high = static_cast<std::uint64_t>(magnitude >> 64);
  return static_cast<std::size_t>(high != 0 ? 64 + std::bit_width(high)
                                            : std::bit_width(static_cast<std::uint64_t>(magnitude)));
}

Dyadic Dyadic::scaled(std::int64_t shift) const {
  Dyadic result = *this;
  if (!is_zero()) result.exponent_ += shift;
  return result;
}

std::size_t Dyadic::hash() const {
  const auto low = large_ ? static_cast<std::uint64_t>(mpz_getlimbn(large_->get_mpz_t(), 0))
                          : static_cast<std::uint64_t>(absolute(small_));
  return (low ^ static_cast<std::uint64_t>(sign()) ^ (static_cast<std::uint64_t>(exponent_) << 40)) *
         0x9e3779b97f4a7c15u;
}

Dyadic Dyadic::operator-() const {
  Dyadic result = *this;
  if (large_) {
    mpz_neg(result.large_->get_mpz_t(), result.large_->get_mpz_t());
  } else {
    result.small_ = -small_;
  }
  return result;
}

Dyadic Dyadic::sum(const Dyadic& a, const Dyadic& b, Sign sign_of_b) {
  const bool subtract = sign_of_b == Sign::minus;
  if (a.is_zero()) return subtract ? -b : b;
  if (b.is_zero()) return a;
  const bool a_is_high = a.exponent_ >= b.exponent_;
  const Dyadic& high = a_is_high ? a : b;
  const Dyadic& low = a_is_high ? b : a;
  const std::int64_t shift = high.exponent_ - low.exponent_;
  // Both summands below 2^126 in units of the lower exponent: so is their sum below 2^127.
  if (!high.large_ && !low.large_ && shift + static_cast<std::int64_t>(high.bits()) <= 126 && low.bits() <= 126) {
    const Small aligned = static_cast<Small>(static_cast<Bits>(high.small_) << shift);
    const Small of_a = a_is_high ? aligned : low.small_;
    const Small of_b = a_is_high ? low.small_ : aligned;
    return {subtract ? of_a - of_b : of_a + of_b, low.exponent_, nullptr};
  }
  auto result = std::make_unique<mpz_class>();
  mpz_ptr sum = result->get_mpz_t();
  mpz_mul_2exp(sum, MantissaView(high), static_cast<mp_bitcnt_t>(shift));
  if (!subtract) {
    mpz_add(sum, sum, MantissaView(low));
  } else if (a_is_high) {
    mpz_sub(sum, sum, MantissaView(low));
  } else {
    mpz_sub(sum, MantissaView(low), sum);
  }
  return {std::move(result), low.exponent_};
}

Dyadic Dyadic::product(const Dyadic& a, const Dyadic& b) {
  if (a.is_zero() || b.is_zero()) return {};
  Small small = 0;
  if (!a.large_ && !b.large_ && !__builtin_mul_overflow(a.small_, b.small_, &small)) {
    return {small, a.exponent_ + b.exponent_, nullptr};
  }
  auto result = std::make_unique<mpz_class>();
  mpz_mul(result->get_mpz_t(), MantissaView(a), MantissaView(b));
  return {std::move(result), a.exponent_ + b.exponent_};
}

bool operator==(const Dyadic& a, const Dyadic& b) {
  if (a.exponent_ != b.exponent_ || !a.large_ != !b.large_) return false;
  return a.large_ ? *a.large_ == *b.large_ : a.small_ == b.small_;
}

std::strong_ordering operator<=>(const Dyadic& a, const Dyadic& b) {
  if (a.sign() != b.sign()) return a.sign() <=> b.sign();
  if (a.is_zero()) return std::strong_ordering::equal;
  if (a.magnitude() != b.magnitude()) {
    return a.sign() > 0 ? a.magnitude() <=> b.magnitude() : b.magnitude() <=> a.magnitude();
  }
  return (a - b).sign() <=> 0;
}

Dyadic common_divisor(const Dyadic& a, const Dyadic& b) {
  if (a.large_ || b.large_) return {gcd(a.mantissa(), b.mantissa()), 0};
  Dyadic::Bits x = Dyadic::absolute(a.small_);
  Dyadic::Bits y = Dyadic::absolute(b.small_);
  while (y != 0) {
    x %= y;
    std::swap(x, y);
  }
  return {static_cast<Dyadic::Small>(x), 0, nullptr};
}

Dyadic exact_quotient(const Dyadic& a, const Dyadic& b) {
  if (!a.large_ && !b.large_) return {a.small_ / b.small_, a.exponent_ - b.exponent_, nullptr};
  mpz_class quotient;
  mpz_divexact(quotient.get_mpz_t(), Dyadic::MantissaView(a), Dyadic::MantissaView(b));
  return {quotient, a.exponent_ - b.exponent_};
}

double Dyadic::nearest() const {
  if (is_zero()) return 0;
  if (!large_ && bits() <= 53 && magnitude() <= 1024 && exponent_ >= -1074)
    return std::ldexp(static_cast<double>(static_cast<std::int64_t>(small_)), static_cast<int>(exponent_));
  const Truncated cut = truncate(mantissa(), exponent_);
  double magnitude = cut.magnitude;
  if (cut.at_least_half && (!cut.exactly_half || is_odd_in_last_place(magnitude))) {
    magnitude = std::nextafter(magnitude, infinity);
  }
  return sign() < 0 ? -magnitude : magnitude;
}

double Dyadic::rounded_down() const {
  if (is_zero()) return 0;
  const Truncated cut = truncate(mantissa(), exponent_);
  if (sign() > 0) return cut.magnitude;
  return cut.exact ? -cut.magnitude : std::nextafter(-cut.magnitude, -infinity);
}

double Dyadic::rounded_up() const { return is_zero() ? 0.0 : -(-*this).rounded_down(); }

}  // namespace csgcast
