// SPDX-License-Identifier: MIT
#include "raycast/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace csgcast {
namespace {

using Coefficients = std::array<double, QuadricForm::term_count>;

// The form times 2^-scale, rounded to nearest, with the largest coefficient in [1/2, 1).
std::int64_t round_scaled(const QuadricForm& form, Coefficients& rounded) {
  std::int64_t scale = std::numeric_limits<std::int64_t>::min();
  for (const Dyadic& c : form.coefficient) {
    if (!c.is_zero()) scale = std::max(scale, c.magnitude());
  }
  for (std::size_t i = 0; i < rounded.size(); ++i) rounded[i] = form.coefficient[i].scaled(-scale).nearest();
  return scale;
}

// q -> f(center + q).
QuadricForm recentred(const QuadricForm& f, Point center) {
  using Form = QuadricForm;
  const Dyadic x(center.x);
  const Dyadic y(center.y);
  const Dyadic z(center.z);
  const Dyadic two(2.0);
  const auto& c = f.coefficient;
  Form g = f;
  g.coefficient[Form::x] += two * c[Form::xx] * x + c[Form::xy] * y + c[Form::xz] * z;
  g.coefficient[Form::y] += two * c[Form::yy] * y + c[Form::xy] * x + c[Form::yz] * z;
  g.coefficient[Form::z] += two * c[Form::zz] * z + c[Form::xz] * x + c[Form::yz] * y;
  g.coefficient[Form::one] = f.at(center);
  return g;
}

}  // namespace

Surface make_surface(QuadricForm canonical, Point center) {
  Surface surface;
  surface.kind = canonical.is_plane() ? SurfaceKind::plane : SurfaceKind::quadric;
  surface.exact = std::move(canonical);
  surface.scale = round_scaled(surface.exact, surface.coefficient);
  for (std::size_t i = 0; i < QuadricForm::term_count; ++i) {
    const bool normal = std::isnormal(surface.coefficient[i]);
    surface.in_range = surface.in_range && (normal || surface.exact.coefficient[i].is_zero());
  }
  if (surface.kind == SurfaceKind::quadric) {
    surface.center = center;
    round_scaled(recentred(surface.exact, center), surface.centered);
  }
  return surface;
}

Vector gradient(const Surface& surface, Point p) {
  using Form = QuadricForm;
  if (surface.kind == SurfaceKind::plane) {
    const auto& c = surface.coefficient;
    return {c[Form::x], c[Form::y], c[Form::z]};
  }
  const auto& c = surface.centered;
  const Vector q = p - surface.center;
  return {2 * c[Form::xx] * q.x + c[Form::xy] * q.y + c[Form::xz] * q.z + c[Form::x],
          2 * c[Form::yy] * q.y + c[Form::xy] * q.x + c[Form::yz] * q.z + c[Form::y],
          2 * c[Form::zz] * q.z + c[Form::xz] * q.x + c[Form::yz] * q.y + c[Form::z]};
}

}  // namespace csgcast
