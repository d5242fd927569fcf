// SPDX-License-Identifier: MIT
#include "raycast/surface/detail/line_filter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "raycast/surface/detail/line_crossings.h"
#include "raycast/surface/detail/quadric_line.h"

namespace csgcast::detail {
namespace {

using Form = QuadricForm;
constexpr double u = 0x1p-53;
// An error bound is computed as a sum of a few positive terms, and rounds itself. Times this it is a bound for certain.
constexpr double rounding_of_bounds = 1 + 0x1p-40;
// Measured from the line's closest approach to a center in the frame's unit cube, every point of the line in the cube
// has |s| <= reach. The two are no farther apart than the cube's diagonal, 2 sqrt(3), and |direction| >= 1.
constexpr double reach = 4;

struct Bounded {
  double value;
  double error;

  bool is_certain() const { return std::fabs(value) > error; }
  double least() const { return std::fabs(value) - error; }
  double most() const { return std::fabs(value) + error; }
};

// f(q + s d) = a s² + 2 b s + c, where q is the line's closest approach to the surface's center, at tau = origin.
struct Quadratic {
  Bounded a;
  Bounded b;
  Bounded c;
  double origin;
};

Quadratic restrict_to_line(const LineFrame& line, const Surface& surface) {
  const QuadricOnLine f = quadric_on_line(line, surface);

  // q is off by the error of `near` and by the rounding of the difference, of the product and of the sum. On each axis
  // |origin d| <= 1.8 |start|.
  const double size = longest(f.q);
  const double e = longest(line.direction);
  const double off = (line.near_error + u * (3 * longest(f.start) + size)) * rounding_of_bounds;
  const double bend = surface.second_degree;
  const double slope = surface.first_degree;
  // There are seven roundings in a, eight in b and ten in c, with that of the coefficient. The rest is what q's error
  // does to b and c.
  const double error_a = 8 * u * bend * e * e;
  const double error_b = (9 * u * (bend * size + slope) + bend * off) * e;
  const double error_c =
      11 * u * ((bend * size + slope) * size + surface.constant) + (2 * bend * size + slope + bend * off) * off;
  return {{f.a, error_a * rounding_of_bounds},
          {f.b, error_b * rounding_of_bounds},
          {f.c, error_c * rounding_of_bounds},
          f.origin};
}

// No crossing, if it is certain that a local surface has none within reach: |a| s² + 2 |b| s stays below |c| there.
std::optional<LineCrossings> none_within_reach(const Quadratic& f, const Surface& surface) {
  const double most = (f.a.most() * reach + 2 * f.b.most()) * reach * rounding_of_bounds;
  if (!surface.is_local || !(f.c.least() > most)) return std::nullopt;
  return none(f.c.value > 0);
}

// The crossings where the discriminant is certainly positive: (-b ± root) / a.
std::optional<LineCrossings> two_roots(const Quadratic& f, const Surface& surface, Bounded discriminant) {
  const double root = std::sqrt(discriminant.value);
  // |sqrt(D) - sqrt(D')| <= |D - D'| / sqrt(D) for D' >= 0.
  const double root_error = discriminant.error / root + u * root;
  // Of the two sums -b ± root the one is taken that does not cancel. It gives one root, and the product of both roots
  // gives the other. The sign of a zero b, which lanes may compute differently, makes no difference.
  const double sum = f.b.value < 0 ? root - f.b.value : -(f.b.value + root);
  const double sum_error = (f.b.error + root_error + u * std::fabs(sum)) * rounding_of_bounds;
  if (!(2 * sum_error < std::fabs(sum))) return std::nullopt;
  const double at_near = f.c.value / sum;
  const double near_error = 2 * (f.c.error + std::fabs(at_near) * sum_error) / std::fabs(sum) + u * std::fabs(at_near);
  const bool rises_at_near = f.b.value >= 0;  // f' there is 2 root if b >= 0, else -2 root

  LineCrossings found;
  if (2 * f.a.error < std::fabs(f.a.value)) {
    const double at_far = sum / f.a.value;
    const double far_error =
        2 * (sum_error + std::fabs(at_far) * f.a.error) / std::fabs(f.a.value) + u * std::fabs(at_far);
    const double largest = std::max(std::fabs(at_near), std::fabs(at_far)) + std::fabs(f.origin);
    found.tau = {f.origin + at_near, f.origin + at_far};
    if (at_near > at_far) std::swap(found.tau[0], found.tau[1]);
    found.error = (std::max(near_error, far_error) + 2 * u * largest) * rounding_of_bounds;
    found.count = 2;
    found.positive_before = f.a.value > 0;
    return found;
  }
  // The sign of a is open: the far root may lie on either side, but it is out of reach if it is certain that
  // |sum| / |a| > reach.
  if (!surface.is_local || !((std::fabs(sum) - sum_error) > reach * f.a.most() * rounding_of_bounds))
    return std::nullopt;
  found.tau[0] = f.origin + at_near;
  found.error = (near_error + 2 * u * (std::fabs(at_near) + std::fabs(f.origin))) * rounding_of_bounds;
  found.count = 1;
  found.positive_before = !rises_at_near;
  return found;
}

// The slope of f along the line. Each term has four roundings: of the coefficient, a product and two additions.
Bounded slope_of(const LineFrame& line, const Surface& plane) {
  return {plane_on_line(line, plane).slope, 5 * u * plane.first_degree * longest(line.direction)};
}

// True if the line is parallel to the plane because every product in the slope has a factor that is zero.
bool is_parallel(const LineFrame& line, const Surface& plane) {
  const auto vanishes = [&](Form::Term term, double d) { return plane.local[term] == 0 || d == 0; };
  const Vector d = line.direction;
  return vanishes(Form::x, d.x) && vanishes(Form::y, d.y) && vanishes(Form::z, d.z);
}

}  // namespace

std::optional<LineCrossings> filtered_plane(const LineFrame& line, const Surface& plane) {
  if (!plane.in_range || !line.in_range) return std::nullopt;
  const double size = longest(line.near);
  const Bounded slope = slope_of(line, plane);
  // The value has one addition more than the slope, and the error of `near`.
  const PlaneOnLine f = plane_on_line(line, plane);
  const Bounded value{f.value,
                      (6 * u * (plane.first_degree * size + plane.constant) + plane.first_degree * line.near_error) *
                          rounding_of_bounds};
  if (2 * slope.error < std::fabs(slope.value)) {
    LineCrossings found;
    const double tau = -value.value / slope.value;
    found.tau[0] = tau;
    found.error = (2 * (value.error + std::fabs(tau) * slope.error) / std::fabs(slope.value) + u * std::fabs(tau)) *
                  rounding_of_bounds;
    found.count = 1;
    found.positive_before = slope.value < 0;
    return found;
  }
  if (is_parallel(line, plane) && value.is_certain()) return none(value.value > 0);
  // The line is nearly parallel: it may be certain that a crossing, if there is one, lies out of reach.
  const double farthest = (reach + 2 * size) * slope.most() * rounding_of_bounds;
  if (plane.is_local && value.least() > farthest) return none(value.value > 0);
  return std::nullopt;
}

std::optional<LineCrossings> filtered_quadric(const LineFrame& line, const Surface& quadric) {
  if (!quadric.in_range || !line.in_range) return std::nullopt;
  const Quadratic f = restrict_to_line(line, quadric);
  const double bb = f.b.value * f.b.value;
  const double ac = f.a.value * f.c.value;
  const double d_error = 2 * std::fabs(f.b.value) * f.b.error + f.b.error * f.b.error +
                         std::fabs(f.a.value) * f.c.error + f.a.error * f.c.most() + 3 * u * (bb + std::fabs(ac));
  const Bounded discriminant{bb - ac, d_error * rounding_of_bounds};
  if (discriminant.is_certain()) {
    if (discriminant.value > 0) return two_roots(f, quadric, discriminant);
    // a and c have the same sign, and neither is zero: either of them tells the side.
    if (f.a.is_certain()) return none(f.a.value > 0);
    if (f.c.is_certain()) return none(f.c.value > 0);
  }
  return none_within_reach(f, quadric);
}

std::optional<LineCrossings> filtered_departure(const Line& line, const Surface& surface) {
  const bool positive = line.departure_side == Sense::positive;
  if (!surface.in_range || !line.in_frame.in_range) return std::nullopt;
  if (surface.kind == SurfaceKind::plane) {
    const Bounded slope = slope_of(line.in_frame, surface);
    if (slope.is_certain()) return none(slope.value > 0);
    return is_parallel(line.in_frame, surface) ? std::optional(none(positive)) : std::nullopt;
  }
  // f is 0 at the start by definition, so f = t (a t + 2 b) there. Along the ray f has the sign of the departure's side
  // at first and that of a in the end. So there is a crossing after the start exactly if these differ.
  const LineFrame& in_frame = line.in_frame;
  const Quadratic f = restrict_to_line(in_frame, surface);
  if (!f.a.is_certain()) return std::nullopt;
  if ((f.a.value > 0) == positive) return none(positive);
  // With s counted from the closest approach at `origin`, where f' = 2 b, the two roots lie equally far on either side
  // of s = -b / a. One of them is the start, so the other one is its mirror image.
  const double middle = f.origin - f.b.value / f.a.value;
  const double start = -in_frame.shift;
  const double other = 2 * middle - start;
  if (2 * f.a.error >= std::fabs(f.a.value) || !(other > start)) return std::nullopt;
  LineCrossings found = none(positive);
  found.tau[0] = other;
  const double ratio_error = 2 * (f.b.error + std::fabs(f.b.value / f.a.value) * f.a.error) / std::fabs(f.a.value);
  found.error =
      (2 * ratio_error + 8 * u * (std::fabs(f.origin) + std::fabs(middle) + std::fabs(start))) * rounding_of_bounds;
  found.count = 1;
  return found;
}

}  // namespace csgcast::detail
