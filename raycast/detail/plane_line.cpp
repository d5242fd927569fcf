// SPDX-License-Identifier: MIT
#include "raycast/detail/plane_line.h"

#include <cmath>
#include <limits>

namespace csgcast::detail {
namespace {

using Form = QuadricForm;
constexpr double u = 0x1p-53;
// Below this a product may have lost bits to underflow, and the relative bounds do not hold.
constexpr double least_trusted = 0x1p-900;
constexpr double greatest_trusted = 0x1p900;

// A computed number and a bound on its distance from the exact one; trusted only if neither underflow nor overflow can
// have touched it.
struct Bounded {
  double value;
  double error;
  bool trusted;
};

// c_x v_x + c_y v_y + c_z v_z + constant. Each coefficient carries a relative error u, each product another, and the
// three additions at most three more: (1 + u)^5 - 1 < 6 u of the sum of magnitudes.
Bounded linear_form(const Surface& plane, double x, double y, double z, double constant) {
  const auto& c = plane.coefficient;
  const double tx = c[Form::x] * x;
  const double ty = c[Form::y] * y;
  const double tz = c[Form::z] * z;
  const double magnitude = std::fabs(tx) + std::fabs(ty) + std::fabs(tz) + std::fabs(constant);
  return {tx + ty + tz + constant, 6 * u * magnitude,
          plane.in_range && magnitude > least_trusted && magnitude < greatest_trusted};
}

// n . d and f(o), exactly and without the plane's scale (which does not change -f(o) / (n . d)).
Dyadic exact_slope(const Surface& plane, Vector d) {
  const auto& c = plane.exact.coefficient;
  return c[Form::x] * Dyadic(d.x) + c[Form::y] * Dyadic(d.y) + c[Form::z] * Dyadic(d.z);
}

Dyadic exact_value(const Line& line, const CrossingView& at) { return at.surface->exact.at(line.ray.origin()); }

// a / b to about 64 bits, then to nearest: relative error below u (1 + 2^-9).
double quotient(const Dyadic& a, const Dyadic& b) {
  if (a.is_zero()) return 0;
  const std::int64_t shift = 66 + static_cast<std::int64_t>(b.bits()) - static_cast<std::int64_t>(a.bits());
  mpz_class numerator = a.mantissa();
  mpz_class denominator = b.mantissa();
  if (shift >= 0) {
    numerator <<= static_cast<mp_bitcnt_t>(shift);
  } else {
    denominator <<= static_cast<mp_bitcnt_t>(-shift);
  }
  return Dyadic(mpz_class(numerator / denominator), a.exponent() - b.exponent() - shift).nearest();
}

bool lies_in_plane_by_zeros(const Surface& plane, Vector d) {
  const auto& c = plane.coefficient;
  return plane.in_range && (c[Form::x] == 0 || d.x == 0) && (c[Form::y] == 0 || d.y == 0) &&
         (c[Form::z] == 0 || d.z == 0);
}

LineCrossings parallel(const Line& line, const Surface& plane) {
  LineCrossings none;
  none.positive_before = sign_at(plane, line.ray.origin()) >= 0;
  return none;
}

LineCrossings single(double t, double error, bool rising) {
  LineCrossings found;
  found.t[0] = t;
  found.error = error;
  found.count = 1;
  found.positive_before = !rising;
  return found;
}

LineCrossings exact_crossings(Line& line, const Surface& plane) {
  ++line.exact_calls;
  const Dyadic slope = exact_slope(plane, line.ray.direction());
  if (slope.is_zero()) return parallel(line, plane);
  const double t = quotient(-plane.exact.at(line.ray.origin()), slope);
  // Beyond the doubles the order must not trust t: an infinite error sends every comparison to the exact stage.
  if (!std::isfinite(t)) {
    return single(std::copysign(std::numeric_limits<double>::max(), t), std::numeric_limits<double>::infinity(),
                  slope.sign() > 0);
  }
  return single(t, 2 * u * std::fabs(t) + std::numeric_limits<double>::denorm_min(), slope.sign() > 0);
}

}  // namespace

LineCrossings plane_crossings(Line& line, SurfaceId id, const Surface& plane) {
  if (id == line.departure) {
    LineCrossings none;
    none.positive_before = line.departure_side == Sense::positive;
    return none;
  }
  const Vector d = line.ray.direction();
  if (lies_in_plane_by_zeros(plane, d)) return parallel(line, plane);
  const Bounded slope = linear_form(plane, d.x, d.y, d.z, 0);
  if (!slope.trusted || std::fabs(slope.value) <= 2 * slope.error) return exact_crossings(line, plane);
  const Point o = line.ray.origin();
  const Bounded value = linear_form(plane, o.x, o.y, o.z, plane.coefficient[Form::one]);
  const double t = -value.value / slope.value;
  if (!value.trusted || !(std::fabs(t) < greatest_trusted)) return exact_crossings(line, plane);
  // |-v/s - exact| <= (dv + |t| ds) / (|s| - ds), and |s| - ds >= |s| / 2; the division's own error is u |t|. The
  // factor 3 covers the rounding of this bound itself, and least_trusted a result that underflows.
  const double error =
      3 * ((value.error + std::fabs(t) * slope.error) / std::fabs(slope.value) + u * std::fabs(t)) + least_trusted;
  return single(t, error, slope.value > 0);
}

std::weak_ordering exact_order(Line& line, const CrossingView& a, const CrossingView& b) {
  ++line.exact_calls;
  const Vector d = line.ray.direction();
  const Dyadic slope_a = exact_slope(*a.surface, d);
  const Dyadic slope_b = exact_slope(*b.surface, d);
  // -va/sa - -vb/sb = (vb sa - va sb) / (sa sb)
  const Dyadic difference = exact_value(line, b) * slope_a - exact_value(line, a) * slope_b;
  return difference.sign() * slope_a.sign() * slope_b.sign() <=> 0;
}

std::weak_ordering exact_order(Line& line, const CrossingView& a, double t) {
  ++line.exact_calls;
  const Dyadic slope = exact_slope(*a.surface, line.ray.direction());
  // -v/s - t = -(v + t s) / s
  const Dyadic value = exact_value(line, a) + Dyadic(t) * slope;
  return -value.sign() * slope.sign() <=> 0;
}

}  // namespace csgcast::detail
