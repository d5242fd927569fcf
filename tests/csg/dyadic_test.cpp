// SPDX-License-Identifier: MIT
#include "csg/exact/dyadic.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "csg/exact/directed.h"
#include "tests/support/catch.h"

using namespace csgcast;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double largest = std::numeric_limits<double>::max();

// Any finite double, all exponents and subnormals alike.
double any_double(std::mt19937_64& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) return value;
  }
}

mpq_class rational(const Dyadic& value) {
  mpq_class result(value.mantissa());
  const auto shift = static_cast<mp_bitcnt_t>(std::abs(value.exponent()));
  if (value.exponent() >= 0) {
    mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), shift);
  } else {
    mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), shift);
  }
  return result;
}

}  // namespace

TEST_CASE("every double survives the way to an exact number and back") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const double value = any_double(random);
    const Dyadic exact(value);
    CHECK(exact.nearest() == value);
    CHECK(exact.rounded_down() == value);
    CHECK(exact.rounded_up() == value);
    CHECK(rational(exact) == mpq_class(value));
  }
  for (const double value : {0.0, smallest, -smallest, largest, std::numeric_limits<double>::min()}) {
    CHECK(Dyadic(value).nearest() == value);
  }
}

TEST_CASE("sums, differences and products are those of rational numbers") {
  std::mt19937_64 random(2);
  for (int i = 0; i < 5000; ++i) {
    const double x = any_double(random), y = any_double(random);
    const Dyadic a(x), b(y);
    const mpq_class p(x), q(y);
    CHECK(rational(a + b) == p + q);
    CHECK(rational(a - b) == p - q);
    CHECK(rational(a * b) == p * q);
    CHECK(rational(-a) == -p);
    CHECK((a <=> b < 0) == (p < q));
    CHECK((a - a).is_zero());
  }
}

TEST_CASE("sums and products are exact around every mantissa length up to 300 bits, 64 and 128 among them") {
  const auto next_to_power = [](int exponent, int offset) {
    return Dyadic(mpz_class((mpz_class(1) << static_cast<mp_bitcnt_t>(exponent)) + offset), -exponent / 2);
  };
  for (int bits = 1; bits <= 300; ++bits) {
    for (const int offset : {-1, 0, 1}) {
      const Dyadic a = next_to_power(bits, offset), b = -next_to_power(bits / 2 + 30, 1);
      CAPTURE(bits, offset);
      CHECK(rational(a * b) == rational(a) * rational(b));
      CHECK(rational(a + b) == rational(a) + rational(b));
      CHECK(rational(a - b) == rational(a) - rational(b));
      CHECK((a + b) - b == a);  // also back from long to short
      CHECK((a * b < a) == (rational(a) * rational(b) < rational(a)));
      CHECK((a - a).is_zero());
      const Dyadic copy = a;
      CHECK(copy == a);
      CHECK(copy.scaled(3).scaled(-3) == a);
    }
  }
}

TEST_CASE("equal values have equal members however they came about") {
  const Dyadic quarter = Dyadic(0.75) - Dyadic(0.5);
  CHECK(quarter == Dyadic(1.0).scaled(-2));
  CHECK(quarter == Dyadic(mpz_class(16), -6));
  CHECK(Dyadic(1.0) - Dyadic(1.0) == Dyadic());
  CHECK(Dyadic(-0.0) == Dyadic());
  CHECK(Dyadic().scaled(1000) == Dyadic());
}

TEST_CASE("sign, bits and magnitude describe the number") {
  CHECK(Dyadic(-3.0).sign() == -1);
  CHECK(Dyadic().sign() == 0);
  CHECK(Dyadic().bits() == 0);
  CHECK(Dyadic(12.0).bits() == 2);       // 3 * 2²
  CHECK(Dyadic(12.0).magnitude() == 4);  // 8 <= 12 < 16
  CHECK(Dyadic(0.5).magnitude() == 0);
}

TEST_CASE("rounding down and up bracket the exact value by neighbouring doubles") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 5000; ++i) {
    const int spread = static_cast<int>(random() % 120);
    const double x = std::ldexp(std::bit_cast<double>((random() >> 12) | 0x3ff0000000000000u),
                                static_cast<int>(random() % 1900) - 1000);
    const Dyadic sum = Dyadic(x) + Dyadic(std::ldexp(any_double(random) > 0 ? 1.37 : -1.37, std::ilogb(x) - spread));
    const double down = sum.rounded_down(), up = sum.rounded_up(), near = sum.nearest();
    CHECK(Dyadic(down) <= sum);
    CHECK(sum <= Dyadic(up));
    if (Dyadic(down) == sum) {
      CHECK(up == down);
    } else {
      CHECK(std::nextafter(down, infinity) == up);
      const auto to_lower = (sum - Dyadic(down)) <=> (Dyadic(up) - sum);
      if (to_lower < 0) CHECK(near == down);
      if (to_lower > 0) CHECK(near == up);
    }
  }
}

TEST_CASE("halfway cases go to the even neighbour") {
  const double ulp = 0x1p-52;
  const Dyadic half = Dyadic(ulp).scaled(-1);
  CHECK((Dyadic(1.0) + half).nearest() == 1.0);
  CHECK((Dyadic(1.0 + ulp) + half).nearest() == 1.0 + 2 * ulp);
  CHECK((-(Dyadic(1.0) + half)).nearest() == -1.0);
  CHECK((Dyadic(1.0) + half + Dyadic(smallest)).nearest() == 1.0 + ulp);
}

TEST_CASE("underflow is gradual and directed") {
  const Dyadic half = Dyadic(smallest).scaled(-1);
  CHECK(half.nearest() == 0);  // a tie, to even
  CHECK(half.rounded_down() == 0);
  CHECK(half.rounded_up() == smallest);
  CHECK((-half).rounded_down() == -smallest);
  CHECK((-half).rounded_up() == 0);
  CHECK((half + half.scaled(-1)).nearest() == smallest);
  CHECK(Dyadic(smallest).scaled(-5000).rounded_up() == smallest);
  CHECK(Dyadic(smallest).scaled(-5000).nearest() == 0);
  const Dyadic one_and_a_half = Dyadic(smallest) + half;
  CHECK(one_and_a_half.nearest() == 2 * smallest);
  CHECK(one_and_a_half.rounded_down() == smallest);
}

TEST_CASE("overflow goes to infinity in the direction of rounding only") {
  const Dyadic huge = Dyadic(largest).scaled(1);
  CHECK(huge.nearest() == infinity);
  CHECK(huge.rounded_up() == infinity);
  CHECK(huge.rounded_down() == largest);
  CHECK((-huge).rounded_up() == -largest);
  CHECK((-huge).rounded_down() == -infinity);
  const Dyadic half_ulp = Dyadic(0x1p970);  // half a unit in the last place of the largest double
  CHECK((Dyadic(largest) + half_ulp).nearest() == infinity);
  CHECK((Dyadic(largest) + half_ulp - Dyadic(1.0)).nearest() == largest);
  CHECK((Dyadic(largest) + Dyadic(1.0)).rounded_down() == largest);
}

TEST_CASE("directed quotients and roots bracket the exact ones within 2^-128") {
  using detail::quotient;
  using detail::square_root;
  using detail::Toward;
  std::mt19937_64 random(4);
  for (int i = 0; i < 2000; ++i) {
    const Dyadic a(any_double(random)), b(any_double(random));
    if (b.is_zero()) continue;
    const Dyadic down = quotient(a, b, Toward::down), up = quotient(a, b, Toward::up);
    CHECK(rational(down) <= rational(a) / rational(b));
    CHECK(rational(a) / rational(b) <= rational(up));
    const Dyadic size = a.sign() < 0 ? -a : a;
    CHECK(rational(up - down) * abs(rational(b)) <= rational(size.scaled(-128)));
    const Dyadic root_down = square_root(size, Toward::down), root_up = square_root(size, Toward::up);
    CHECK(root_down * root_down <= size);
    CHECK(size <= root_up * root_up);
    CHECK(root_up - root_down <= root_up.scaled(-128));
  }
  CHECK(square_root(Dyadic(9.0).scaled(-2), Toward::up) == Dyadic(1.5));
  CHECK(square_root(Dyadic(), Toward::up).is_zero());
  CHECK(quotient(Dyadic(6.0), Dyadic(-1.5), Toward::up) == Dyadic(-4.0));
}
