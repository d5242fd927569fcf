// SPDX-License-Identifier: MIT
#include "raycast/surface/quadric/quadric.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "csg/base/length.h"
#include "csg/exact/quadric_form.h"
#include "raycast/surface/detail/bounded.h"
#include "raycast/surface/detail/line_crossings.h"

namespace csgcast::detail {
namespace {

using Form = QuadricForm;

// f = a s² + 2 b s + c with s = tau - origin, about the line's closest approach to the surface's center. There is least
// cancellation there.
struct QuadricOnLine {
  double a;
  double b;
  double c;
  double origin;
  Vector start;  // from the center to the line's `near`
  Vector q;      // from the center to the closest approach
};

QuadricOnLine quadric_on_line(const LineFrame& line, const Surface& quadric) {
  const auto& k = quadric.local;
  const auto times_matrix = [&k](Vector v) {
    return Vector{k[Form::xx] * v.x + 0.5 * (k[Form::xy] * v.y + k[Form::xz] * v.z),
                  k[Form::yy] * v.y + 0.5 * (k[Form::xy] * v.x + k[Form::yz] * v.z),
                  k[Form::zz] * v.z + 0.5 * (k[Form::xz] * v.x + k[Form::yz] * v.y)};
  };
  const Vector d = line.direction;
  const Vector start = line.near - quadric.center;
  const double origin = -dot(start, d) * line.inverse_squared;
  const Vector q = start + origin * d;
  const Vector linear{k[Form::x], k[Form::y], k[Form::z]};
  const Vector image = times_matrix(d);
  return {dot(d, image),
          dot(q, image) + 0.5 * dot(linear, d),
          dot(q, times_matrix(q)) + dot(linear, q) + k[Form::one],
          origin,
          start,
          q};
}

// f(q + s d) = a s² + 2 b s + c about the line's closest approach to the surface's center, at tau = origin.
struct Quadratic {
  Bounded a;
  Bounded b;
  Bounded c;
  double origin;
};

Quadratic restrict_to_line(const LineFrame& line, const Surface& surface) {
  const QuadricOnLine f = quadric_on_line(line, surface);

  // q is off by the error of `near`, and by the rounding of the difference, the product and the sum. |origin d| <= 1.8
  // |start| on each axis.
  const double size = longest(f.q);
  const double e = longest(line.direction);
  const double off = (line.near_error + unit_roundoff * (3 * longest(f.start) + size)) * rounding_of_bounds;
  const double bend = surface.second_degree;
  const double slope = surface.first_degree;
  // There are seven roundings in a, eight in b and ten in c, including those of the coefficients. The error of q adds
  // to b and c.
  const double error_a = 8 * unit_roundoff * bend * e * e;
  const double error_b = (9 * unit_roundoff * (bend * size + slope) + bend * off) * e;
  const double error_c = 11 * unit_roundoff * ((bend * size + slope) * size + surface.constant) +
                         (2 * bend * size + slope + bend * off) * off;
  return {{f.a, error_a * rounding_of_bounds},
          {f.b, error_b * rounding_of_bounds},
          {f.c, error_c * rounding_of_bounds},
          f.origin};
}

// Handles a local surface without a crossing within reach: |a| s² + 2 |b| s stays below |c| there.
std::optional<LineCrossings> none_within_reach(const LineFrame& line, const Quadratic& f, const Surface& surface) {
  const double most = (f.a.most() * reach + 2 * f.b.most()) * reach * rounding_of_bounds;
  if (!surface.is_local || !line.knows_cube || !(f.c.least() > most)) return std::nullopt;
  return none(f.c.value > 0);
}

// The two roots (-b ± root) / a, if both certainly exist.
std::optional<LineCrossings> two_roots(const LineFrame& line, const Quadratic& f, const Surface& surface,
                                       Bounded discriminant) {
  const double root = std::sqrt(discriminant.value);
  // |sqrt(D) - sqrt(D')| <= |D - D'| / sqrt(D) for D' >= 0.
  const double root_error = discriminant.error / root + unit_roundoff * root;
  // One sum does not cancel. The other root follows from the product of both. If b is zero, its sign makes no
  // difference, and lanes may compute the sign differently.
  const double sum = f.b.value < 0 ? root - f.b.value : -(f.b.value + root);
  const double sum_error = (f.b.error + root_error + unit_roundoff * std::fabs(sum)) * rounding_of_bounds;
  if (!(2 * sum_error < std::fabs(sum))) return std::nullopt;
  const double at_near = f.c.value / sum;
  const double near_error =
      2 * (f.c.error + std::fabs(at_near) * sum_error) / std::fabs(sum) + unit_roundoff * std::fabs(at_near);
  const bool rises_at_near = f.b.value >= 0;  // f' is 2 root or -2 root there

  LineCrossings found;
  if (2 * f.a.error < std::fabs(f.a.value)) {
    const double at_far = sum / f.a.value;
    const double far_error =
        2 * (sum_error + std::fabs(at_far) * f.a.error) / std::fabs(f.a.value) + unit_roundoff * std::fabs(at_far);
    const double largest = std::max(std::fabs(at_near), std::fabs(at_far)) + std::fabs(f.origin);
    found.few = {f.origin + at_near, f.origin + at_far};
    if (at_near > at_far) std::swap(found.few[0], found.few[1]);
    found.error = (std::max(near_error, far_error) + 2 * unit_roundoff * largest) * rounding_of_bounds;
    found.count = 2;
    found.positive_before = f.a.value > 0;
    return found;
  }
  // The sign of a is open, so the far root is at least this far out, on one side or the other.
  const bool far_is_out = (std::fabs(sum) - sum_error) > reach * f.a.most() * rounding_of_bounds;
  if (!surface.is_local || !line.knows_cube || !far_is_out) return std::nullopt;
  found.few[0] = f.origin + at_near;
  found.error = (near_error + 2 * unit_roundoff * (std::fabs(at_near) + std::fabs(f.origin))) * rounding_of_bounds;
  found.count = 1;
  found.positive_before = !rises_at_near;
  return found;
}

std::optional<LineCrossings> crossings(const LineFrame& line, const Surface& quadric) {
  if (!quadric.in_range || !line.in_range) return std::nullopt;
  const Quadratic f = restrict_to_line(line, quadric);
  const double bb = f.b.value * f.b.value;
  const double ac = f.a.value * f.c.value;
  const double d_error = 2 * std::fabs(f.b.value) * f.b.error + f.b.error * f.b.error +
                         std::fabs(f.a.value) * f.c.error + f.a.error * f.c.most() +
                         3 * unit_roundoff * (bb + std::fabs(ac));
  const Bounded discriminant{bb - ac, d_error * rounding_of_bounds};
  if (discriminant.is_certain()) {
    if (discriminant.value > 0) return two_roots(line, f, quadric, discriminant);
    // a and c have the same sign and are not zero, so either of them gives the sign of f.
    if (f.a.is_certain()) return none(f.a.value > 0);
    if (f.c.is_certain()) return none(f.c.value > 0);
  }
  return none_within_reach(line, f, quadric);
}

std::optional<LineCrossings> after_departure(const Line& line, const Surface& surface) {
  const bool positive = line.departure_side == Sense::positive;
  if (!surface.in_range || !line.in_frame.in_range) return std::nullopt;
  // By definition c is 0 at the start, so f = t (a t + 2 b). At first f has the sign of the departure's side, and in
  // the end that of a. So there is a crossing after the start exactly if these two signs differ.
  const LineFrame& in_frame = line.in_frame;
  const Quadratic f = restrict_to_line(in_frame, surface);
  if (!f.a.is_certain()) return std::nullopt;
  if ((f.a.value > 0) == positive) return none(positive);
  // f' = 2 b at the closest approach, `origin`. The two roots lie equally far on either side of -b / a from there.
  const double middle = f.origin - f.b.value / f.a.value;
  const double start = -in_frame.shift;
  const double other = 2 * middle - start;
  if (2 * f.a.error >= std::fabs(f.a.value) || !(other > start)) return std::nullopt;
  LineCrossings found = none(positive);
  found.few[0] = other;
  const double ratio_error = 2 * (f.b.error + std::fabs(f.b.value / f.a.value) * f.a.error) / std::fabs(f.a.value);
  found.error = (2 * ratio_error + 8 * unit_roundoff * (std::fabs(f.origin) + std::fabs(middle) + std::fabs(start))) *
                rounding_of_bounds;
  found.count = 1;
  return found;
}

LineCrossings plain_crossings(const LineFrame& line, const Surface& surface) {
  const QuadricOnLine f = quadric_on_line(line, surface);
  const double discriminant = f.b * f.b - f.a * f.c;
  if (f.a == 0) return f.b == 0 ? none(f.c >= 0) : one(f.origin - f.c / (2 * f.b), f.b < 0);
  if (!(discriminant > 0)) return none(f.a > 0);
  const double root = std::sqrt(discriminant);
  const double sum = f.b < 0 ? root - f.b : -(f.b + root);
  LineCrossings found = none(f.a > 0);
  found.few = {f.origin + f.c / sum, f.origin + sum / f.a};
  if (found.few[0] > found.few[1]) std::swap(found.few[0], found.few[1]);
  found.count = found.few[0] < found.few[1] ? 2 : 0;
  return found;
}

LineCrossings plain_departure(const Line& line, const Surface& surface) {
  const bool positive = line.departure_side == Sense::positive;
  const QuadricOnLine f = quadric_on_line(line.in_frame, surface);
  if (f.a == 0 || (f.a > 0) == positive) return none(positive);
  const double start = -line.in_frame.shift;
  return one(std::fmax(2 * (f.origin - f.b / f.a) - start, start), positive);
}

}  // namespace

std::optional<LineCrossings> filtered_quadric(const Line& line, SurfaceId id, const Surface& quadric) {
  return id == line.departure ? after_departure(line, quadric) : crossings(line.in_frame, quadric);
}

LineCrossings uncertified_quadric(const Line& line, SurfaceId id, const Surface& quadric) {
  return id == line.departure ? plain_departure(line, quadric) : plain_crossings(line.in_frame, quadric);
}

}  // namespace csgcast::detail
