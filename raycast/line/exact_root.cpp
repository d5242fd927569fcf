// SPDX-License-Identifier: MIT
#include "raycast/line/exact_root.h"

#include "csg/base/precondition.h"

namespace csgcast::detail {
namespace {

int sign_of_sum(const Dyadic& a, const Dyadic& b) { return (a + b).sign(); }

Dyadic signed_square(const Dyadic& a) { return a.sign() < 0 ? -(a * a) : a * a; }

// The sign of x + y sqrt(d), where d >= 0. If the two terms have opposite signs, their squares are compared.
int sign_with_root(const Dyadic& x, const Dyadic& y, const Dyadic& d) {
  const int sx = x.sign();
  const int sy = d.is_zero() ? 0 : y.sign();
  if (sx == 0 || sy == 0 || sx == sy) return sx != 0 ? sx : sy;
  return sign_of_sum(signed_square(x), signed_square(y) * d);
}

// The sign of x + y sqrt(d) + z sqrt(e), where d, e >= 0.
int sign_with_roots(const Dyadic& x, const Dyadic& y, const Dyadic& d, const Dyadic& z, const Dyadic& e) {
  if (e.is_zero() || z.is_zero()) return sign_with_root(x, y, d);
  if (d.is_zero() || y.is_zero()) return sign_with_root(x, z, e);
  // Let r = y sqrt(d) + z sqrt(e). Its sign follows from squares. Then x is compared with r by x² - r² = (x² - y² d -
  // z² e) - 2 y z sqrt(d e).
  const Dyadic yyd = y * y * d;
  const Dyadic zze = z * z * e;
  const int sr = y.sign() == z.sign() ? y.sign() : y.sign() * (yyd - zze).sign();
  const int sx = x.sign();
  if (sx == 0 || sr == 0 || sx == sr) return sx != 0 ? sx : sr;
  const Dyadic two(2.0);
  return sx * sign_with_root(x * x - yyd - zze, -two * y * z, d * e);
}

}  // namespace

ExactRoot ExactRoot::quotient(const Dyadic& dividend, const Dyadic& divisor) {
  CSGCAST_PRECONDITION(!divisor.is_zero());
  ExactRoot root(dividend);
  root.q = divisor;
  return root;
}

ExactRoot ExactRoot::of(const Dyadic& a, const Dyadic& b, const Dyadic& c, unsigned root) {
  if (a.is_zero()) return quotient(-c, b);
  ExactRoot result = quotient(-b, Dyadic(2.0) * a);
  result.d = b * b - Dyadic(4.0) * a * c;
  result.s = (root == 0) == (a.sign() > 0) ? -1 : 1;
  return result;
}

// a - b = ((pa qb - pb qa) + sa qb sqrt(da) - sb qa sqrt(db)) / (qa qb)
std::strong_ordering operator<=>(const ExactRoot& a, const ExactRoot& b) {
  const Dyadic sa(static_cast<double>(a.s));
  const Dyadic sb(static_cast<double>(-b.s));
  const int sign = sign_with_roots(a.p * b.q - b.p * a.q, sa * b.q, a.d, sb * a.q, b.d);
  return sign * a.q.sign() * b.q.sign() <=> 0;
}

}  // namespace csgcast::detail
