// SPDX-License-Identifier: MIT
#include "raycast/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace csgcast {
namespace {

using Form = QuadricForm;
using Coefficients = Surface::Coefficients;

// The form times a power of two, rounded to nearest, with the largest coefficient in [1/2, 1). False if one that is not
// zero came out as zero or subnormal, which would void the relative bound.
bool round_scaled(const QuadricForm& form, Coefficients& rounded, Coefficients* left_over = nullptr) {
  std::int64_t scale = std::numeric_limits<std::int64_t>::min();
  for (const Dyadic& c : form.coefficient) {
    if (!c.is_zero()) scale = std::max(scale, c.magnitude());
  }
  bool in_range = true;
  for (std::size_t i = 0; i < rounded.size(); ++i) {
    const Dyadic scaled = form.coefficient[i].scaled(-scale);
    rounded[i] = scaled.nearest();
    if (left_over != nullptr) (*left_over)[i] = (scaled - Dyadic(rounded[i])).nearest();
    in_range = in_range && (form.coefficient[i].is_zero() || std::isnormal(rounded[i]));
  }
  return in_range;
}

// q -> f(origin + 2^exponent q).
QuadricForm in_coordinates(const QuadricForm& f, const ExactPoint& origin, int exponent) {
  const auto& [x, y, z] = origin;
  const auto& c = f.coefficient;
  const Dyadic two(2.0);
  Form g = f;
  g.coefficient[Form::x] += two * c[Form::xx] * x + c[Form::xy] * y + c[Form::xz] * z;
  g.coefficient[Form::y] += two * c[Form::yy] * y + c[Form::xy] * x + c[Form::yz] * z;
  g.coefficient[Form::z] += two * c[Form::zz] * z + c[Form::xz] * x + c[Form::yz] * y;
  g.coefficient[Form::one] += (c[Form::xx] * x + c[Form::xy] * y + c[Form::xz] * z + c[Form::x]) * x +
                              (c[Form::yy] * y + c[Form::yz] * z + c[Form::y]) * y + (c[Form::zz] * z + c[Form::z]) * z;
  for (std::size_t i = 0; i < Form::one; ++i) {
    g.coefficient[i] = g.coefficient[i].scaled(i < Form::x ? 2 * std::int64_t{exponent} : exponent);
  }
  return g;
}

double magnitude_sum(const Coefficients& c, std::size_t begin, std::size_t end) {
  double sum = 0;
  for (std::size_t i = begin; i < end; ++i) sum += std::fabs(c[i]);
  return sum;
}

}  // namespace

Surface make_surface(QuadricForm canonical, const Frame& frame, Point near, bool is_local) {
  Surface surface;
  surface.kind = canonical.is_plane() ? SurfaceKind::plane : SurfaceKind::quadric;
  surface.is_local = is_local;
  surface.exact = std::move(canonical);
  surface.in_range = round_scaled(surface.exact, surface.world);
  ExactPoint origin;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (surface.kind == SurfaceKind::quadric)
      surface.center[axis] = std::ldexp(near[axis] - frame.center[axis], -frame.exponent);
    origin[axis] = Dyadic(frame.center[axis]) + Dyadic(surface.center[axis]).scaled(frame.exponent);
  }
  surface.in_range =
      round_scaled(in_coordinates(surface.exact, origin, frame.exponent), surface.local, &surface.local_low) &&
      surface.in_range;
  surface.second_degree = magnitude_sum(surface.local, 0, Form::x);
  surface.first_degree = magnitude_sum(surface.local, Form::x, Form::one);
  surface.constant = std::fabs(surface.local[Form::one]);
  return surface;
}

Vector gradient(const Surface& surface, const Frame& frame, Point p) {
  const auto& c = surface.local;
  if (surface.kind == SurfaceKind::plane) return {c[Form::x], c[Form::y], c[Form::z]};
  Vector q;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    q[axis] = std::ldexp(p[axis] - frame.center[axis], -frame.exponent) - surface.center[axis];
  }
  return {2 * c[Form::xx] * q.x + c[Form::xy] * q.y + c[Form::xz] * q.z + c[Form::x],
          2 * c[Form::yy] * q.y + c[Form::xy] * q.x + c[Form::yz] * q.z + c[Form::y],
          2 * c[Form::zz] * q.z + c[Form::xz] * q.x + c[Form::yz] * q.y + c[Form::z]};
}

}  // namespace csgcast
