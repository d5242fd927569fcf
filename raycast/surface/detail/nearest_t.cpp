// SPDX-License-Identifier: MIT
#include "raycast/surface/detail/nearest_t.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "csg/base/length.h"
#include "csg/exact/quadric_form.h"
#include "raycast/surface/detail/twofold_form.h"
#include "raycast/surface/kind.h"

namespace csgcast::detail {
namespace {

using Form = QuadricForm;
constexpr double u = unit_roundoff;

using Point2 = std::array<Twofold, 3>;

// The point at tau, relative to the surface's center.
Point2 point_at(const LineFrame& line, const Surface& surface, double tau) {
  Point2 q;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Twofold start = Twofold{line.near[axis], line.near_low[axis]} + two_sum(-surface.center[axis], 0);
    q[axis] = start + two_product(tau, line.direction[axis]);
  }
  return q;
}

// Computes f(q). Coefficients that are zero cost nothing.
Twofold value_at(const Surface& surface, const Point2& q) {
  const auto coefficient = [&](std::size_t i) { return Twofold{surface.local[i], surface.local_low[i]}; };
  Twofold sum = coefficient(Form::one);
  const auto add = [&](std::size_t i, auto&& factor) {
    if (surface.local[i] != 0) sum = sum + coefficient(i) * factor();
  };
  for (std::size_t axis = 0; axis < 3; ++axis) add(Form::x + axis, [&] { return q[axis]; });
  if (surface.is_plane) return sum;
  for (std::size_t axis = 0; axis < 3; ++axis) add(Form::xx + axis, [&] { return q[axis] * q[axis]; });
  add(Form::xy, [&] { return q[0] * q[1]; });
  add(Form::xz, [&] { return q[0] * q[2]; });
  add(Form::yz, [&] { return q[1] * q[2]; });
  return sum;
}

// f'(tau), in double.
double slope_at(const LineFrame& line, const Surface& surface, const Point2& q) {
  const auto& c = surface.local;
  const Vector p{q[0].high, q[1].high, q[2].high};
  const Vector gradient{2 * c[Form::xx] * p.x + c[Form::xy] * p.y + c[Form::xz] * p.z + c[Form::x],
                        2 * c[Form::yy] * p.y + c[Form::xy] * p.x + c[Form::yz] * p.z + c[Form::y],
                        2 * c[Form::zz] * p.z + c[Form::xz] * p.x + c[Form::yz] * p.y + c[Form::z]};
  return dot(gradient, line.direction);
}

// Rounds shift + tau + step, if every number within `error` of it rounds to the same double. The product with the unit
// is exact.
std::optional<double> rounded(const LineFrame& line, double tau, double step, double error) {
  const Twofold base = two_sum(line.shift, tau);
  const Twofold sum = two_sum(base.high, step);
  const double low = base.low + sum.low;
  const double slack = error + 2 * u * std::fabs(low) + 0x1p-1000;
  const double below = sum.high + (low - slack);
  const double above = sum.high + (low + slack);
  const double t = below * line.unit;
  const bool scales_exactly = std::fabs(t) > 0x1p-1000 || t == 0;  // no subnormal number
  if (below == above && scales_exactly && std::isfinite(t)) return t;
  return std::nullopt;
}

std::optional<double> newton(const LineFrame& line, const CrossingView& crossing) {
  const Surface& surface = *crossing.surface;
  const double tau = crossing.tau();
  const Point2 q = point_at(line, surface, tau);
  const Twofold value = value_at(surface, q);
  const double slope = slope_at(line, surface, q);
  const double step = -value.high / slope;

  const double size = std::max({std::fabs(q[0].high), std::fabs(q[1].high), std::fabs(q[2].high)});
  const double e = longest(line.direction);
  const double bend = surface.second_degree;
  const double steepness = 2 * bend * size + surface.first_degree;
  // q takes two twofold sums and a product. f takes up to ten products of three factors and ten sums, with an error
  // below 64 u² of the sum of magnitudes. Using only the high part loses u of the value.
  const double off =
      line.near_low_error + 16 * u * u * (longest(line.near) + longest(surface.center) + std::fabs(tau) * e);
  const double value_error =
      64 * u * u * ((bend * size + surface.first_degree) * size + surface.constant) + steepness * off;
  // These are the relative errors of the slope and of the division, and the curvature that one Newton step leaves out.
  const double slope_error = 8 * u * steepness * e;
  if (!(4 * slope_error < std::fabs(slope))) return std::nullopt;
  // A quadratic rises at one of its roots and falls at the other. A step that is short compared with the bend leads to
  // the root at which the form goes as the slope does. If the two roots are near each other, that may be the wrong one.
  const bool rises = !crossing.found->positive_after(crossing.root);
  const double most = std::fabs(value.high) + value_error;
  if ((slope > 0) != rises || !(8 * bend * e * e * most <= slope * slope)) return std::nullopt;
  const double curvature = bend * e * e * step * step;
  const double error =
      2 * (value_error + curvature + std::fabs(step) * slope_error + 4 * u * std::fabs(value.high)) / std::fabs(slope);
  return rounded(line, tau, step, error);
}

}  // namespace

std::optional<double> nearest_t(const Line& line, const CrossingView& crossing) {
  // The form is different for the surface of a departure, and speed does not matter there.
  if (crossing.id == line.departure || !crossing.surface->in_range || !line.in_frame.in_range) return std::nullopt;
  if (const std::optional<double> t = newton(line.in_frame, crossing)) return t;
  const std::optional<TwofoldRoot> root = crossing.surface->kind->twofold_root(line, crossing);
  return root ? rounded(line.in_frame, root->tau.high, root->tau.low, root->error) : std::nullopt;
}

}  // namespace csgcast::detail
