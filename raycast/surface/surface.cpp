// SPDX-License-Identifier: MIT
#include "raycast/surface/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "csg/base/length.h"
#include "raycast/surface/rounded_form.h"

namespace csgcast {
namespace {

using Form = QuadricForm;

static_assert(std::tuple_size_v<Surface::Coefficients> == Form::term_count);
using Coefficients = Surface::Coefficients;
using detail::in_coordinates;
using detail::round_scaled;

double magnitude_sum(const Coefficients& c, std::size_t begin, std::size_t end) {
  double sum = 0;
  for (std::size_t i = begin; i < end; ++i) sum += std::fabs(c[i]);
  return sum;
}

}  // namespace

Surface make_surface(PackedForm canonical, const Frame& frame, Point near, bool is_local) {
  const QuadricForm form = canonical.unpacked();
  Surface surface;
  surface.kind = form.is_plane() ? SurfaceKind::plane : SurfaceKind::quadric;
  surface.is_local = is_local;
  surface.exact = std::move(canonical);
  surface.in_range = round_scaled(form, surface.world);
  ExactPoint origin;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (surface.kind == SurfaceKind::quadric)
      surface.center[axis] = std::ldexp(near[axis] - frame.center[axis], -frame.exponent);
    origin[axis] = Dyadic(frame.center[axis]) + Dyadic(surface.center[axis]).scaled(frame.exponent);
  }
  surface.in_range =
      round_scaled(in_coordinates(form, origin, frame.exponent), surface.local, &surface.local_low) && surface.in_range;
  const auto& local = surface.local;
  if (surface.kind == SurfaceKind::plane)
    surface.normal = normalised(Vector{local[Form::x], local[Form::y], local[Form::z]});
  surface.is_mixed = local[Form::xy] != 0 || local[Form::xz] != 0 || local[Form::yz] != 0;
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
