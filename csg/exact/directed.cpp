// SPDX-License-Identifier: MIT
#include "csg/exact/directed.h"

#include <algorithm>

#include "csg/base/precondition.h"

namespace csgcast::detail {
namespace {

constexpr std::int64_t working_bits = 128;

}  // namespace

Dyadic quotient(const Dyadic& dividend, const Dyadic& divisor, Toward toward) {
  CSGCAST_PRECONDITION(!divisor.is_zero());
  if (dividend.is_zero()) return {};
  // Shift the dividend so that the integer quotient has more than working_bits bits.
  const auto gap = static_cast<std::int64_t>(divisor.bits()) - static_cast<std::int64_t>(dividend.bits());
  const std::int64_t shift = std::max<std::int64_t>(0, gap + working_bits + 1);
  const mpz_class shifted = dividend.mantissa() << static_cast<mp_bitcnt_t>(shift);
  mpz_class whole;
  const auto divide = toward == Toward::down ? mpz_fdiv_q : mpz_cdiv_q;
  divide(whole.get_mpz_t(), shifted.get_mpz_t(), divisor.mantissa().get_mpz_t());
  return {std::move(whole), dividend.exponent() - divisor.exponent() - shift};
}

Dyadic square_root(const Dyadic& value, Toward toward) {
  CSGCAST_PRECONDITION(value.sign() >= 0);
  if (value.is_zero()) return {};
  // An even exponent, and twice working_bits bits under the root.
  std::int64_t shift = std::max<std::int64_t>(0, 2 * working_bits + 2 - static_cast<std::int64_t>(value.bits()));
  if ((value.exponent() - shift) % 2 != 0) ++shift;
  const mpz_class radicand = value.mantissa() << static_cast<mp_bitcnt_t>(shift);
  mpz_class root, rest;
  mpz_sqrtrem(root.get_mpz_t(), rest.get_mpz_t(), radicand.get_mpz_t());
  if (toward == Toward::up && sgn(rest) != 0) ++root;
  return {std::move(root), (value.exponent() - shift) / 2};
}

}  // namespace csgcast::detail
