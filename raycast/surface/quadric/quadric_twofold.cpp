// SPDX-License-Identifier: MIT
#include "raycast/surface/quadric/quadric.h"

#include <cmath>

#include "raycast/surface/detail/twofold_form.h"

namespace csgcast::detail {
namespace {

using Form = QuadricForm;

// f = a s² + 2 b s + c with s = tau - origin, about a point near the closest approach to the surface's center.
struct Quadratic {
  TwofoldBounded a;
  TwofoldBounded b;
  TwofoldBounded c;
  double origin;
};

TwofoldVector times_matrix(const Surface& surface, const TwofoldVector& v) {
  const auto entry = [&](Form::Term term, double factor, Twofold x) {
    return surface.local[term] == 0 ? Twofold{} : coefficient(surface, term) * (x * factor);
  };
  return {entry(Form::xx, 1, v[0]) + entry(Form::xy, 0.5, v[1]) + entry(Form::xz, 0.5, v[2]),
          entry(Form::xy, 0.5, v[0]) + entry(Form::yy, 1, v[1]) + entry(Form::yz, 0.5, v[2]),
          entry(Form::xz, 0.5, v[0]) + entry(Form::yz, 0.5, v[1]) + entry(Form::zz, 1, v[2])};
}

Quadratic restrict_to_line(const LineFrame& line, const Surface& surface) {
  const Vector d = line.direction;
  const TwofoldVector start = start_of(line, surface);
  const double origin = -(start[0].high * d.x + start[1].high * d.y + start[2].high * d.z) * line.inverse_squared;
  TwofoldVector q;
  for (std::size_t axis = 0; axis < 3; ++axis) q[axis] = start[axis] + two_product(origin, d[axis]);
  const TwofoldVector along{Twofold{d.x, 0}, Twofold{d.y, 0}, Twofold{d.z, 0}};
  const TwofoldVector image = times_matrix(surface, along);
  const TwofoldVector linear = first_degree(surface);

  const double e = longest(d);
  const double size = longest(q);
  const double off = (line.near_low_error + 4 * uu * (longest(start) + size)) * rounding_of_bounds;
  const double bend = surface.second_degree;
  const double slope = surface.first_degree;
  const double error_a = 32 * uu * bend * e * e;
  const double error_b = (48 * uu * (bend * size + slope) + bend * off) * e;
  const double error_c =
      64 * uu * ((bend * size + slope) * size + surface.constant) + (2 * bend * size + slope + bend * off) * off;
  return {{dot(image, d), error_a * rounding_of_bounds + underflow},
          {dot(image, q) + dot(linear, d) * 0.5, error_b * rounding_of_bounds + underflow},
          {dot(q, times_matrix(surface, q)) + dot(linear, q) + coefficient(surface, Form::one),
           error_c * rounding_of_bounds + underflow},
          origin};
}

TwofoldBounded discriminant_of(const Quadratic& f) {
  const Twofold bb = f.b.value * f.b.value;
  const Twofold ac = f.a.value * f.c.value;
  const double b = std::fabs(f.b.value.high), a = std::fabs(f.a.value.high), c = std::fabs(f.c.value.high);
  const double error = 2 * b * f.b.error + f.b.error * f.b.error + a * f.c.error + f.a.error * (c + f.c.error) +
                       12 * uu * (bb.high + std::fabs(ac.high));
  return {bb + -ac, error * rounding_of_bounds + underflow};
}

// Computes sqrt(D), where D > 0 is certain. One Newton step on the double's root leaves a relative error of 4 u².
TwofoldBounded square_root(const TwofoldBounded& discriminant) {
  const double root = std::sqrt(discriminant.value.high);
  const Twofold left = discriminant.value + -two_product(root, root);
  return {fast_two_sum(root, left.high / (2 * root)), 2 * discriminant.error / root + 4 * uu * root};
}

// The two roots, as values of s. If the sign of a is open, only the root nearest 0.
struct Roots {
  TwofoldBounded near;
  std::optional<TwofoldBounded> far;
  bool far_is_lower = false;
};

std::optional<Roots> roots_of(const Quadratic& f, const TwofoldBounded& discriminant) {
  const TwofoldBounded root = square_root(discriminant);
  const bool is_negative = std::signbit(f.b.value.high);
  const Twofold sum = -(f.b.value + (is_negative ? -root.value : root.value));
  const TwofoldBounded bounded_sum{sum, (f.b.error + root.error + 4 * uu * std::fabs(sum.high)) * rounding_of_bounds};
  if (!bounded_sum.is_certain()) return std::nullopt;
  Roots roots{quotient(f.c, bounded_sum), std::nullopt};
  if (f.a.is_certain()) {
    roots.far = quotient(bounded_sum, f.a);
    roots.far_is_lower = f.a.is_positive() != is_negative;
  }
  return roots;
}

TwofoldRoot from_origin(const TwofoldBounded& s, double origin) {
  const Twofold tau = s.value + two_sum(origin, 0);
  return {tau, (s.error + 4 * uu * std::fabs(tau.high)) * rounding_of_bounds};
}

}  // namespace

std::optional<LineCrossings> twofold_quadric(const Line& line, SurfaceId id, const Surface& surface) {
  if (is_beyond_twofold(line, id, surface)) return std::nullopt;
  const Quadratic f = restrict_to_line(line.in_frame, surface);
  const TwofoldBounded discriminant = discriminant_of(f);
  if (!discriminant.is_certain() || !f.a.is_certain()) return std::nullopt;
  LineCrossings found;
  found.positive_before = f.a.is_positive();
  if (!discriminant.is_positive()) return found;
  const std::optional<Roots> roots = roots_of(f, discriminant);
  if (!roots) return std::nullopt;
  found.count = 2;
  report(found, roots->far_is_lower ? 0 : 1, from_origin(*roots->far, f.origin));
  report(found, roots->far_is_lower ? 1 : 0, from_origin(roots->near, f.origin));
  return found;
}

std::optional<TwofoldRoot> twofold_quadric_root(const Line& line, const CrossingView& crossing) {
  const Surface& surface = *crossing.surface;
  if (is_beyond_twofold(line, crossing.id, surface)) return std::nullopt;
  const Quadratic f = restrict_to_line(line.in_frame, surface);
  const TwofoldBounded discriminant = discriminant_of(f);
  if (!discriminant.is_certain() || !discriminant.is_positive()) return std::nullopt;
  const std::optional<Roots> roots = roots_of(f, discriminant);
  if (!roots) return std::nullopt;
  // If a crossing's partner is out of reach, the crossing is the one near the closest approach.
  if (crossing.found->count == 1) return from_origin(roots->near, f.origin);
  if (!roots->far) return std::nullopt;
  return from_origin((crossing.root == 0) == roots->far_is_lower ? *roots->far : roots->near, f.origin);
}

}  // namespace csgcast::detail
