// SPDX-License-Identifier: MIT
#include "raycast/detail/quadric_line.h"

#include <cmath>
#include <utility>

namespace csgcast::detail {
namespace {

using Form = QuadricForm;
using Coefficients = std::array<double, Form::term_count>;

// f(q + s d) = a s² + 2 b s + c.
struct Quadratic {
  double a;
  double b;
  double c;
};

Vector times_matrix(const Coefficients& k, Vector v) {
  return {k[Form::xx] * v.x + 0.5 * (k[Form::xy] * v.y + k[Form::xz] * v.z),
          k[Form::yy] * v.y + 0.5 * (k[Form::xy] * v.x + k[Form::yz] * v.z),
          k[Form::zz] * v.z + 0.5 * (k[Form::xz] * v.x + k[Form::yz] * v.y)};
}

Quadratic restrict_to_line(const Coefficients& k, Vector q, Vector d) {
  const Vector linear{k[Form::x], k[Form::y], k[Form::z]};
  const Vector image = times_matrix(k, d);
  return {dot(d, image), dot(q, image) + 0.5 * dot(linear, d),
          dot(q, times_matrix(k, q)) + dot(linear, q) + k[Form::one]};
}

// Keeps the finite ones of two ascending roots: a root at infinity is none, and the sign changes with the one that left
// below.
LineCrossings of_roots(double lower, double upper, bool positive_before) {
  LineCrossings found;
  found.positive_before = positive_before;
  if (std::isinf(lower) && lower < 0) {
    found.positive_before = !positive_before;
  } else if (std::isfinite(lower)) {
    found.t[found.count++] = lower;
  }
  if (std::isfinite(upper)) found.t[found.count++] = upper;
  return found;
}

LineCrossings linear_crossing(const Quadratic& f, double t0) {
  LineCrossings found;
  if (f.b == 0) {
    found.positive_before = f.c >= 0;
    return found;
  }
  found.positive_before = f.b < 0;
  found.t[0] = t0 - f.c / (2 * f.b);
  found.count = std::isfinite(found.t[0]) ? 1 : 0;
  return found;
}

// The line starts on the surface, where c is 0 by definition: f(t) = t (a t + 2 b). On the way f has the sign of the
// departure's side at first and that of a in the end, so there is a crossing after the start exactly if these differ;
// at a silhouette rounding may put it at 0.
LineCrossings departing_crossings(const Quadratic& f, bool positive_side) {
  LineCrossings found;
  found.positive_before = positive_side;
  const double other = -2 * f.b / f.a;
  if (f.a != 0 && (f.a > 0) != positive_side && std::isfinite(other)) {
    found.t[0] = std::fmax(other, 0);
    found.count = 1;
  }
  return found;
}

}  // namespace

LineCrossings quadric_crossings(const Line& line, SurfaceId id, const Surface& quadric) {
  const Vector d = line.ray.direction();
  const Vector start = line.ray.origin() - quadric.center;
  if (id == line.departure) {
    return departing_crossings(restrict_to_line(quadric.centered, start, d), line.departure_side == Sense::positive);
  }

  const double t0 = -dot(start, d) / dot(d, d);
  const Quadratic f = restrict_to_line(quadric.centered, start + t0 * d, d);
  if (f.a == 0) return linear_crossing(f, t0);
  const double discriminant = f.b * f.b - f.a * f.c;
  if (!(discriminant > 0)) return of_roots(INFINITY, INFINITY, f.a > 0);
  // The sum that does not cancel, then the other root from the product of both.
  const double sum = -(f.b + std::copysign(std::sqrt(discriminant), f.b));
  double lower = t0 + sum / f.a;
  double upper = t0 + f.c / sum;
  if (lower > upper) std::swap(lower, upper);
  if (lower == upper) return of_roots(INFINITY, INFINITY, f.a > 0);
  return of_roots(lower, upper, f.a > 0);
}

}  // namespace csgcast::detail
