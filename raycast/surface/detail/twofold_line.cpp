// SPDX-License-Identifier: MIT
#include "raycast/surface/detail/twofold_line.h"

#include <array>
#include <cmath>

#include "csg/base/precondition.h"

namespace csgcast::detail {
namespace {

using Form = QuadricForm;
constexpr double uu = 0x1p-106;  // u²
constexpr double rounding_of_bounds = 1 + 0x1p-40;
constexpr double underflow = 0x1p-1000;  // far above what low parts lose to it

struct Bounded {
  Twofold value;
  double error;

  bool is_certain() const { return std::fabs(value.high) > 2 * error; }  // the low part is below u of the high one
  bool is_positive() const { return value.high > 0; }
};

using Vector2 = std::array<Twofold, 3>;

// f = a s² + 2 b s + c with s = tau - origin, about a point near the closest approach to the surface's center.
struct Quadratic {
  Bounded a;
  Bounded b;
  Bounded c;
  double origin;
};

double longest(const Vector2& q) {
  return std::fmax(std::fabs(q[0].high), std::fmax(std::fabs(q[1].high), std::fabs(q[2].high)));
}

Twofold coefficient(const Surface& surface, std::size_t term) { return {surface.local[term], surface.local_low[term]}; }

Vector2 times_matrix(const Surface& surface, const Vector2& v) {
  const auto entry = [&](Form::Term term, double factor, Twofold x) {
    return surface.local[term] == 0 ? Twofold{} : coefficient(surface, term) * (x * factor);
  };
  return {entry(Form::xx, 1, v[0]) + entry(Form::xy, 0.5, v[1]) + entry(Form::xz, 0.5, v[2]),
          entry(Form::xy, 0.5, v[0]) + entry(Form::yy, 1, v[1]) + entry(Form::yz, 0.5, v[2]),
          entry(Form::xz, 0.5, v[0]) + entry(Form::yz, 0.5, v[1]) + entry(Form::zz, 1, v[2])};
}

Twofold dot(const Vector2& a, const Vector2& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Twofold dot(const Vector2& a, Vector b) { return a[0] * b.x + a[1] * b.y + a[2] * b.z; }

Vector2 first_degree(const Surface& surface) {
  return {coefficient(surface, Form::x), coefficient(surface, Form::y), coefficient(surface, Form::z)};
}

// `near` from the surface's center; off by near_low_error and a relative 3 u².
Vector2 start_of(const LineFrame& line, const Surface& surface) {
  Vector2 start;
  for (std::size_t axis = 0; axis < 3; ++axis)
    start[axis] = Twofold{line.near[axis], line.near_low[axis]} + two_sum(-surface.center[axis], 0);
  return start;
}

Quadratic restrict_to_line(const LineFrame& line, const Surface& surface) {
  const Vector d = line.direction;
  const Vector2 start = start_of(line, surface);
  const double origin = -(start[0].high * d.x + start[1].high * d.y + start[2].high * d.z) * line.inverse_squared;
  Vector2 q;
  for (std::size_t axis = 0; axis < 3; ++axis) q[axis] = start[axis] + two_product(origin, d[axis]);
  const Vector2 along{Twofold{d.x, 0}, Twofold{d.y, 0}, Twofold{d.z, 0}};
  const Vector2 image = times_matrix(surface, along);
  const Vector2 linear = first_degree(surface);

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

Bounded discriminant_of(const Quadratic& f) {
  const Twofold bb = f.b.value * f.b.value;
  const Twofold ac = f.a.value * f.c.value;
  const double b = std::fabs(f.b.value.high), a = std::fabs(f.a.value.high), c = std::fabs(f.c.value.high);
  const double error = 2 * b * f.b.error + f.b.error * f.b.error + a * f.c.error + f.a.error * (c + f.c.error) +
                       12 * uu * (bb.high + std::fabs(ac.high));
  return {bb + -ac, error * rounding_of_bounds + underflow};
}

// sqrt(D), D > 0 for certain: one Newton step on the double's root leaves a relative 4 u².
Bounded square_root(const Bounded& discriminant) {
  const double root = std::sqrt(discriminant.value.high);
  const Twofold left = discriminant.value + -two_product(root, root);
  return {fast_two_sum(root, left.high / (2 * root)), 2 * discriminant.error / root + 4 * uu * root};
}

// a / b, off by a relative 16 u² and by what its operands are off. Precondition: b is certain.
Bounded quotient(const Bounded& a, const Bounded& b) {
  CSGCAST_PRECONDITION(b.is_certain());
  const double first = a.value.high / b.value.high;
  const Twofold left = a.value + -(b.value * first);
  const Twofold value = fast_two_sum(first, left.high / b.value.high);
  const double size = std::fabs(value.high);
  return {value, (4 * (a.error + size * b.error) / std::fabs(b.value.high) + 16 * uu * size) * rounding_of_bounds};
}

// The two roots with s, or the one nearest 0 if the sign of a is open.
struct Roots {
  Bounded near;
  std::optional<Bounded> far;
  bool far_is_lower = false;
};

std::optional<Roots> roots_of(const Quadratic& f, const Bounded& discriminant) {
  const Bounded root = square_root(discriminant);
  const bool is_negative = std::signbit(f.b.value.high);
  const Twofold sum = -(f.b.value + (is_negative ? -root.value : root.value));
  const Bounded bounded_sum{sum, (f.b.error + root.error + 4 * uu * std::fabs(sum.high)) * rounding_of_bounds};
  if (!bounded_sum.is_certain()) return std::nullopt;
  Roots roots{quotient(f.c, bounded_sum), std::nullopt};
  if (f.a.is_certain()) {
    roots.far = quotient(bounded_sum, f.a);
    roots.far_is_lower = f.a.is_positive() != is_negative;
  }
  return roots;
}

TwofoldRoot from_origin(const Bounded& s, double origin) {
  const Twofold tau = s.value + two_sum(origin, 0);
  return {tau, (s.error + 4 * uu * std::fabs(tau.high)) * rounding_of_bounds};
}

// -v / s with v and s in twofold.
std::optional<TwofoldRoot> plane_root(const LineFrame& line, const Surface& plane) {
  const Vector2 normal = first_degree(plane);
  const double e = longest(line.direction);
  const Vector2 start = start_of(line, plane);
  const double size = longest(start);
  const Bounded slope{dot(normal, line.direction), 24 * uu * plane.first_degree * e + underflow};
  if (!slope.is_certain()) return std::nullopt;
  const Bounded value{dot(normal, start) + coefficient(plane, Form::one),
                      (32 * uu * (plane.first_degree * size + plane.constant) +
                       plane.first_degree * (line.near_low_error + 4 * uu * size)) *
                              rounding_of_bounds +
                          underflow};
  const Bounded ratio = quotient(value, slope);
  return TwofoldRoot{-ratio.value, ratio.error};
}

void report(LineCrossings& found, unsigned root, const TwofoldRoot& tau) {
  found.tau[root] = tau.tau.high;
  found.error = std::fmax(found.error, tau.error + 0x1p-53 * std::fabs(tau.tau.high));
}

std::optional<LineCrossings> plane_crossings(const LineFrame& line, const Surface& plane) {
  const std::optional<TwofoldRoot> root = plane_root(line, plane);
  if (!root) return std::nullopt;
  LineCrossings found;
  found.count = 1;
  found.positive_before = dot(first_degree(plane), line.direction).high < 0;
  report(found, 0, *root);
  return found;
}

}  // namespace

std::optional<LineCrossings> twofold_crossings(const LineFrame& line, const Surface& surface) {
  if (!surface.in_range || !line.in_range) return std::nullopt;
  if (surface.kind == SurfaceKind::plane) return plane_crossings(line, surface);
  const Quadratic f = restrict_to_line(line, surface);
  const Bounded discriminant = discriminant_of(f);
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

std::optional<TwofoldRoot> twofold_root(const LineFrame& line, const CrossingView& crossing) {
  const Surface& surface = *crossing.surface;
  if (!surface.in_range || !line.in_range) return std::nullopt;
  if (surface.kind == SurfaceKind::plane) return plane_root(line, surface);
  const Quadratic f = restrict_to_line(line, surface);
  const Bounded discriminant = discriminant_of(f);
  if (!discriminant.is_certain() || !discriminant.is_positive()) return std::nullopt;
  const std::optional<Roots> roots = roots_of(f, discriminant);
  if (!roots) return std::nullopt;
  // A crossing whose partner is out of reach is the one near the closest approach.
  if (crossing.found->count == 1) return from_origin(roots->near, f.origin);
  if (!roots->far) return std::nullopt;
  return from_origin((crossing.root == 0) == roots->far_is_lower ? *roots->far : roots->near, f.origin);
}

int certain_order(const TwofoldRoot& a, const TwofoldRoot& b) {
  const Twofold gap = a.tau + -b.tau;
  if (!(std::fabs(gap.high) > 2 * (a.error + b.error))) return 0;
  return gap.high < 0 ? -1 : 1;
}

}  // namespace csgcast::detail
