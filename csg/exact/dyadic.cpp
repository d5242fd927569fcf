// SPDX-License-Identifier: MIT
#include "csg/exact/dyadic.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

Dyadic::Dyadic(double value) {
  if (value == 0) return;
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  mantissa_ = mpz_class(std::ldexp(fraction, 53));
  exponent_ = exponent - 53;
  normalise();
}

Dyadic::Dyadic(mpz_class mantissa, std::int64_t exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {
  normalise();
}

void Dyadic::normalise() {
  if (sgn(mantissa_) == 0) {
    exponent_ = 0;
    return;
  }
  const mp_bitcnt_t zeros = mpz_scan1(mantissa_.get_mpz_t(), 0);
  if (zeros == 0) return;
  mpz_tdiv_q_2exp(mantissa_.get_mpz_t(), mantissa_.get_mpz_t(), zeros);
  exponent_ += static_cast<std::int64_t>(zeros);
}

std::size_t Dyadic::bits() const { return is_zero() ? 0 : mpz_sizeinbase(mantissa_.get_mpz_t(), 2); }

Dyadic Dyadic::scaled(std::int64_t shift) const {
  Dyadic result = *this;
  if (!is_zero()) result.exponent_ += shift;
  return result;
}

Dyadic Dyadic::operator-() const {
  Dyadic result = *this;
  mpz_neg(result.mantissa_.get_mpz_t(), result.mantissa_.get_mpz_t());
  return result;
}

Dyadic& Dyadic::operator+=(const Dyadic& other) {
  if (other.is_zero()) return *this;
  if (is_zero()) return *this = other;
  if (exponent_ <= other.exponent_) {
    mantissa_ += mpz_class(other.mantissa_ << static_cast<mp_bitcnt_t>(other.exponent_ - exponent_));
  } else {
    mantissa_ <<= static_cast<mp_bitcnt_t>(exponent_ - other.exponent_);
    mantissa_ += other.mantissa_;
    exponent_ = other.exponent_;
  }
  normalise();
  return *this;
}

Dyadic& Dyadic::operator-=(const Dyadic& other) { return *this += -other; }

Dyadic& Dyadic::operator*=(const Dyadic& other) {
  // A product of odd mantissas is odd, so no normalisation but for zero.
  mantissa_ *= other.mantissa_;
  exponent_ = is_zero() ? 0 : exponent_ + other.exponent_;
  return *this;
}

std::strong_ordering operator<=>(const Dyadic& a, const Dyadic& b) {
  if (a.sign() != b.sign()) return a.sign() <=> b.sign();
  if (a.is_zero()) return std::strong_ordering::equal;
  if (a.magnitude() != b.magnitude()) {
    return a.sign() > 0 ? a.magnitude() <=> b.magnitude() : b.magnitude() <=> a.magnitude();
  }
  return (a - b).sign() <=> 0;
}

double Dyadic::nearest() const {
  if (is_zero()) return 0;
  const Truncated cut = truncate(mantissa_, exponent_);
  double magnitude = cut.magnitude;
  if (cut.at_least_half && (!cut.exactly_half || is_odd_in_last_place(magnitude))) {
    magnitude = std::nextafter(magnitude, infinity);
  }
  return sign() < 0 ? -magnitude : magnitude;
}

double Dyadic::rounded_down() const {
  if (is_zero()) return 0;
  const Truncated cut = truncate(mantissa_, exponent_);
  if (sign() > 0) return cut.magnitude;
  return cut.exact ? -cut.magnitude : std::nextafter(-cut.magnitude, -infinity);
}

double Dyadic::rounded_up() const { return is_zero() ? 0.0 : -(-*this).rounded_down(); }

}  // namespace csgcast
