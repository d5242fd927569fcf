// SPDX-License-Identifier: MIT
#include "raycast/surface/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "csg/base/length.h"
#include "csg/exact/quadric_form.h"
#include "raycast/surface/kinds.h"
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
  surface.kind = *std::find_if(surface_kinds().begin(), surface_kinds().end(),
                               [&](const SurfaceKind* kind) { return kind->takes != nullptr && kind->takes(form); });
  surface.is_plane = surface.kind == &plane_kind;
  surface.is_local = is_local;
  surface.exact = std::move(canonical);
  surface.in_range = round_scaled(form, surface.world);
  ExactPoint origin;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!surface.is_plane) surface.center[axis] = std::ldexp(near[axis] - frame.center[axis], -frame.exponent);
    origin[axis] = Dyadic(frame.center[axis]) + Dyadic(surface.center[axis]).scaled(frame.exponent);
  }
  surface.in_range =
      round_scaled(in_coordinates(form, origin, frame.exponent), surface.local, &surface.local_low) && surface.in_range;
  const auto& local = surface.local;
  if (surface.is_plane) surface.normal = normalised(Vector{local[Form::x], local[Form::y], local[Form::z]});
  surface.is_mixed = local[Form::xy] != 0 || local[Form::xz] != 0 || local[Form::yz] != 0;
  surface.second_degree = magnitude_sum(surface.local, 0, Form::x);
  surface.first_degree = magnitude_sum(surface.local, Form::x, Form::one);
  surface.constant = std::fabs(surface.local[Form::one]);
  return surface;
}

Surface make_surface(std::shared_ptr<const OtherForm> canonical, const SurfaceKind& kind, bool is_local) {
  Surface surface;
  surface.kind = &kind;
  surface.is_plane = false;
  surface.is_local = is_local;
  surface.in_range = false;
  surface.other = std::move(canonical);
  return surface;
}

Vector gradient(const Surface& surface, const Frame& frame, Point p) {
  return surface.kind->gradient(surface, frame, p);
}

}  // namespace csgcast
