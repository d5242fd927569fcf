// SPDX-License-Identifier: MIT
#include "csg/exact/dyadic.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "csg/base/precondition.h"

namespace csgcast {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// |m| 2^e rounded toward zero to a double, and what was cut off.
struct Truncated {
  double magnitude;
  bool exact;
  bool at_least_half;  // true if at least half a unit in the last place was cut off
  bool exactly_half;
};

// magnitude * 2^exponent. Precondition: that is a double.
double scaled_double(std::uint64_t magnitude, std::int64_t exponent) {
  [[maybe_unused]] const auto bits = static_cast<std::int64_t>(std::bit_width(magnitude));
  CSGCAST_PRECONDITION(bits <= 53 && exponent >= -1074 && bits + exponent <= 1024);
  constexpr std::int64_t bias = 1023;
  if (exponent <= -bias || exponent > bias)
    return std::ldexp(static_cast<double>(magnitude), static_cast<int>(exponent));
  return static_cast<double>(magnitude) * std::bit_cast<double>(static_cast<std::uint64_t>(exponent + bias) << 52);
}

constexpr Truncated beyond_doubles{std::numeric_limits<double>::max(), false, true, false};

// The unit in the last place of a double that begins with the number's first bit: 53 bits, or fewer for subnormal ones.
std::int64_t last_place(std::int64_t bits, std::int64_t exponent) {
  return std::max<std::int64_t>(bits + exponent - 53, -1074);
}

// Truncates a mantissa of 128 bits or more. It is always longer than a double's, and since it is odd, something is cut
// off, and never exactly half a unit.
Truncated truncate(const mpz_class& mantissa, std::int64_t exponent) {
  constexpr std::int64_t limb_bits = 64;
  const mpz_srcptr m = mantissa.get_mpz_t();
  const auto bits = static_cast<std::int64_t>(mpz_sizeinbase(m, 2));
  if (bits + exponent > 1024) return beyond_doubles;
  const std::int64_t unit = last_place(bits, exponent);
  const std::int64_t cut = unit - exponent;
  if (cut > bits) return {0.0, false, false, false};
  const auto limb = [m](std::int64_t i) { return mpz_getlimbn(m, static_cast<mp_size_t>(i)); };  // 0 past the last
  const std::int64_t low = cut / limb_bits, offset = cut % limb_bits;
  const std::uint64_t kept =
      limb(low) >> offset | (offset != 0 ? limb(low + 1) << (limb_bits - offset) : std::uint64_t{0});
  const bool half = (limb((cut - 1) / limb_bits) >> ((cut - 1) % limb_bits) & 1) != 0;
  return {scaled_double(kept, unit), false, half, false};
}

__extension__ using Bits = unsigned __int128;

Truncated truncate(Bits magnitude, std::int64_t bits, std::int64_t exponent) {
  if (bits + exponent > 1024) return beyond_doubles;
  const std::int64_t unit = last_place(bits, exponent);
  const std::int64_t cut = unit - exponent;
  if (cut <= 0) return {scaled_double(static_cast<std::uint64_t>(magnitude), exponent), true, false, false};
  if (cut > bits) return {0.0, false, false, false};
  const Bits half_unit = Bits{1} << (cut - 1);
  const Bits rest = magnitude & (2 * half_unit - 1);
  return {scaled_double(static_cast<std::uint64_t>(magnitude >> cut), unit), rest == 0, rest >= half_unit,
          rest == half_unit};
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
  CSGCAST_PRECONDITION(std::isfinite(value));
  if (value == 0) return;
  constexpr int fraction_bits = 52;
  constexpr std::uint64_t implicit_one = std::uint64_t{1} << fraction_bits;
  const auto word = std::bit_cast<std::uint64_t>(value);
  const auto biased = static_cast<std::int64_t>(word >> fraction_bits & 0x7ff);
  const std::uint64_t magnitude = (word & (implicit_one - 1)) | (biased != 0 ? implicit_one : 0);
  small_ = value < 0 ? -static_cast<Small>(magnitude) : static_cast<Small>(magnitude);
  exponent_ = std::max<std::int64_t>(biased, 1) - 1075;
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
  const int zeros = trailing_zeros(static_cast<Bits>(small_));
  small_ >>= zeros;  // arithmetic, and exact: only zeros are cut off
  exponent_ += zeros;
}

mpz_class Dyadic::mantissa() const {
  mpz_class result;
  mpz_set(result.get_mpz_t(), MantissaView(*this));
  return result;
}

std::size_t Dyadic::hash() const {
  const auto low = large_ ? static_cast<std::uint64_t>(mpz_getlimbn(large_->get_mpz_t(), 0))
                          : static_cast<std::uint64_t>(absolute(small_));
  return (low ^ static_cast<std::uint64_t>(sign()) ^ (static_cast<std::uint64_t>(exponent_) << 40)) *
         0x9e3779b97f4a7c15u;
}

Dyadic Dyadic::sum(const Dyadic& a, const Dyadic& b, Sign sign_of_b) {
  CSGCAST_PRECONDITION(!a.is_zero() && !b.is_zero());
  const bool subtract = sign_of_b == Sign::minus;
  const bool a_is_high = a.exponent_ >= b.exponent_;
  const Dyadic& high = a_is_high ? a : b;
  const Dyadic& low = a_is_high ? b : a;
  const std::int64_t shift = high.exponent_ - low.exponent_;
  // Both summands are below 2^126 in units of the lower exponent, so their sum is below 2^127.
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
  CSGCAST_PRECONDITION(!a.is_zero() && !b.is_zero());
  const auto fits_a_word = [](Small value) { return value == static_cast<std::int64_t>(value); };
  if (!a.large_ && !b.large_ && fits_a_word(a.small_) && fits_a_word(b.small_)) {
    Dyadic result;  // a product of odd numbers is odd
    result.small_ = a.small_ * b.small_;
    result.exponent_ = a.exponent_ + b.exponent_;
    return result;
  }
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
  if (x == 0) std::swap(x, y);
  // Both are odd, so the divisor is odd, and their difference is even. Source: Stein 1967.
  while (y != 0 && x != 1) {
    y >>= Dyadic::trailing_zeros(y);
    if (x > y) std::swap(x, y);
    y -= x;
  }
  return {static_cast<Dyadic::Small>(x), 0, nullptr};
}

Dyadic exact_quotient(const Dyadic& a, const Dyadic& b) {
  CSGCAST_PRECONDITION(!b.is_zero() && mpz_divisible_p(Dyadic::MantissaView(a), Dyadic::MantissaView(b)) != 0);
  if (!a.large_ && !b.large_) return {a.small_ / b.small_, a.exponent_ - b.exponent_, nullptr};
  mpz_class quotient;
  mpz_divexact(quotient.get_mpz_t(), Dyadic::MantissaView(a), Dyadic::MantissaView(b));
  return {quotient, a.exponent_ - b.exponent_};
}

double Dyadic::nearest(std::int64_t shift) const {
  if (is_zero()) return 0;
  const std::int64_t exponent = exponent_ + shift;
  const Truncated cut =
      large_ ? truncate(*large_, exponent) : truncate(absolute(small_), static_cast<std::int64_t>(bits()), exponent);
  double magnitude = cut.magnitude;
  if (cut.at_least_half && (!cut.exactly_half || is_odd_in_last_place(magnitude))) {
    magnitude = std::nextafter(magnitude, infinity);
  }
  return sign() < 0 ? -magnitude : magnitude;
}

double Dyadic::rounded_down() const {
  if (is_zero()) return 0;
  const Truncated cut =
      large_ ? truncate(*large_, exponent_) : truncate(absolute(small_), static_cast<std::int64_t>(bits()), exponent_);
  if (sign() > 0) return cut.magnitude;
  return cut.exact ? -cut.magnitude : std::nextafter(-cut.magnitude, -infinity);
}

double Dyadic::rounded_up() const { return is_zero() ? 0.0 : -(-*this).rounded_down(); }

}  // namespace csgcast
