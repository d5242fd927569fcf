// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "csg/exact/dyadic.h"
#include "csg/exact/hull.h"

namespace csgcast {
namespace {

using ExactVector = std::array<Dyadic, 3>;

ExactVector exact_difference(Point a, Point b) {
  return {Dyadic(a.x) - Dyadic(b.x), Dyadic(a.y) - Dyadic(b.y), Dyadic(a.z) - Dyadic(b.z)};
}

int exact_orientation(Point a, Point b, Point c, Point d) {
  const ExactVector u = exact_difference(b, a), v = exact_difference(c, a), w = exact_difference(d, a);
  const Dyadic determinant =
      w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) + w[2] * (u[0] * v[1] - u[1] * v[0]);
  return determinant.sign();
}

double largest_component(Vector v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

}  // namespace

int orientation(Point a, Point b, Point c, Point d) {
  const Vector u = b - a, v = c - a, w = d - a;
  const double yz = u.y * v.z, zy = u.z * v.y, zx = u.z * v.x, xz = u.x * v.z, xy = u.x * v.y, yx = u.y * v.x;
  const double determinant = w.x * (yz - zy) + w.y * (zx - xz) + w.z * (xy - yx);
  const double permanent = std::fabs(w.x) * (std::fabs(yz) + std::fabs(zy)) +
                           std::fabs(w.y) * (std::fabs(zx) + std::fabs(xz)) +
                           std::fabs(w.z) * (std::fabs(xy) + std::fabs(yx));
  // With e = 2^-53, each of the six terms is a product of three rounded differences, rounded on its way through two
  // products, one difference and at most two sums: eight factors 1 + O(e), so |error| <= (8 e + O(e²)) * (exact
  // permanent), and the computed permanent is less than the exact one by at most 8 roundings as well. 10 e covers both.
  // If no difference exceeds 2^300 nothing overflows, and underflow adds at most 6 * 2^-1075 * (2^300 + 1), far below
  // 2^-700.
  constexpr double relative = 10 * 0x1p-53;
  const double bound = relative * permanent + 0x1p-700;
  const double largest = std::max({largest_component(u), largest_component(v), largest_component(w)});
  if (largest <= 0x1p300) {  // false for NaN, too
    if (determinant > bound) return 1;
    if (determinant < -bound) return -1;
    // A difference is 0 only if it is exactly 0. So points in a common axis-aligned plane need no exact arithmetic.
    if ((u.x == 0 && v.x == 0 && w.x == 0) || (u.y == 0 && v.y == 0 && w.y == 0) || (u.z == 0 && v.z == 0 && w.z == 0))
      return 0;
  }
  return exact_orientation(a, b, c, d);
}

}  // namespace csgcast
