// SPDX-License-Identifier: MIT
#include "tests/bench/accuracy/textbook_line.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "csg/base/length.h"
#include "csg/exact/quadric_form.h"
#include "raycast/surface/detail/line_crossings.h"

namespace csgcast::bench {
namespace {

using Form = QuadricForm;
using detail::none;
using detail::one;

// a s² + 2 b s + c.
struct Quadratic {
  double a;
  double b;
  double c;
};

Quadratic restrict_to_line(const Surface::Coefficients& k, Vector o, Vector d) {
  const auto times_matrix = [&k](Vector v) {
    return Vector{k[Form::xx] * v.x + 0.5 * (k[Form::xy] * v.y + k[Form::xz] * v.z),
                  k[Form::yy] * v.y + 0.5 * (k[Form::xy] * v.x + k[Form::yz] * v.z),
                  k[Form::zz] * v.z + 0.5 * (k[Form::xz] * v.x + k[Form::yz] * v.y)};
  };
  const Vector linear{k[Form::x], k[Form::y], k[Form::z]};
  const Vector image = times_matrix(d);
  return {dot(d, image), dot(o, image) + 0.5 * dot(linear, d), dot(o, times_matrix(o)) + dot(linear, o) + k[Form::one]};
}

double plain_discriminant(const Quadratic& f) { return f.b * f.b - f.a * f.c; }

double kahan_discriminant(const Quadratic& f) {
  const double bb = f.b * f.b;
  const double ac = f.a * f.c;
  return (bb - ac) + (std::fma(f.b, f.b, -bb) - std::fma(f.a, f.c, -ac));
}

LineCrossings two(double tau, double other_tau, bool positive_before) {
  LineCrossings found = none(positive_before);
  if (tau > other_tau) std::swap(tau, other_tau);
  found.few = {tau, other_tau};
  found.count = tau < other_tau ? 2 : 0;
  return found;
}

// From t to the line's tau. The unit is a power of two, and where the crossing is about as far from the ray's origin as
// the scene is, the difference is exact: t comes out of the caster as it went in.
double tau_of(const LineFrame& line, double t) { return t / line.unit - line.shift; }

double longest(Vector v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

// The unit of the scene's frame: a power of two.
double frame_unit(const Line& line) {
  return line.in_frame.unit * (longest(line.ray.direction()) / longest(line.in_frame.direction));
}

// No bound is known; this is what the root of a discriminant that cancels may be off by, with coordinates of that size
// in the frame. The caster only uses it to leave out what is elsewhere on the ray.
LineCrossings guessing_error(LineCrossings found, double size) {
  found.error = 0x1p-24 * (1 + size);
  return found;
}

template <class Discriminant>
LineCrossings from_world(const Line& line, const Surface& surface, Discriminant discriminant) {
  const Surface::Coefficients& k = surface.world;
  const Vector o = line.ray.origin() - Point{};
  const Vector d = line.ray.direction();
  const auto tau = [&line](double t) { return tau_of(line.in_frame, t); };
  if (surface.is_plane) {
    const Vector normal{k[Form::x], k[Form::y], k[Form::z]};
    const double value = dot(normal, o) + k[Form::one];
    const double slope = dot(normal, d);
    return slope == 0 ? none(value >= 0) : one(tau(-value / slope), slope < 0);
  }
  const Quadratic f = restrict_to_line(k, o, d);
  if (f.a == 0) return f.b == 0 ? none(f.c >= 0) : one(tau(-f.c / (2 * f.b)), f.b < 0);
  const double square = discriminant(f);
  if (!(square > 0)) return none(f.a > 0);
  const double root = std::sqrt(square);
  return two(tau((-f.b - root) / f.a), tau((-f.b + root) / f.a), f.a > 0);
}

template <class Discriminant>
LineCrossings crossings_in_world(const Line& line, const Surface& surface, Discriminant discriminant) {
  return guessing_error(from_world(line, surface, discriminant),
                        longest(line.ray.origin() - Point{}) / frame_unit(line));
}

// From the surface's center to the ray's origin in units of the frame, by way of the center's world coordinates:
// rounded to doubles as a program has it that places its solids by plain transforms.
Vector from_center(const Line& line, const Surface& surface) {
  const LineFrame& frame = line.in_frame;
  const double unit = frame_unit(line);
  Vector start;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double o = line.ray.origin()[axis];
    const double frame_center = o - unit * (frame.near[axis] - frame.shift * frame.direction[axis]);
    const double center = frame_center + unit * surface.center[axis];
    start[axis] = (o - center) / unit;
  }
  return start;
}

LineCrossings shifted_plane(const LineFrame& line, const Surface& plane, Vector start) {
  const Vector normal{plane.local[Form::x], plane.local[Form::y], plane.local[Form::z]};
  const double value = dot(normal, start) + plane.local[Form::one];
  const double slope = dot(normal, line.direction);
  return slope == 0 ? none(value >= 0) : one(-value / slope - line.shift, slope < 0);
}

LineCrossings shifted_quadric(const LineFrame& line, const Surface& quadric, Vector start) {
  const double approach = -dot(start, line.direction) * line.inverse_squared;
  const Quadratic f = restrict_to_line(quadric.local, start + approach * line.direction, line.direction);
  const auto tau = [&](double s) { return (approach + s) - line.shift; };
  if (f.a == 0) return f.b == 0 ? none(f.c >= 0) : one(tau(-f.c / (2 * f.b)), f.b < 0);
  const double square = plain_discriminant(f);
  if (!(square > 0)) return none(f.a > 0);
  const double sum = -(f.b + std::copysign(std::sqrt(square), f.b));
  return two(tau(f.c / sum), tau(sum / f.a), f.a > 0);
}

}  // namespace

LineCrossings plain_crossings(const Line& line, SurfaceId, const Surface& surface, ExactCalls&) {
  return crossings_in_world(line, surface, plain_discriminant);
}

LineCrossings kahan_crossings(const Line& line, SurfaceId, const Surface& surface, ExactCalls&) {
  return crossings_in_world(line, surface, kahan_discriminant);
}

LineCrossings shifted_crossings(const Line& line, SurfaceId, const Surface& surface, ExactCalls&) {
  const Vector start = from_center(line, surface);
  const bool is_plane = surface.is_plane;
  return guessing_error(
      is_plane ? shifted_plane(line.in_frame, surface, start) : shifted_quadric(line.in_frame, surface, start),
      longest(start));
}

}  // namespace csgcast::bench
