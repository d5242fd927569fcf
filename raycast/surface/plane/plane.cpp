// SPDX-License-Identifier: MIT
#include "raycast/surface/plane/plane.h"

#include "csg/exact/quadric_form.h"
#include "raycast/surface/detail/exact_line.h"
#include "raycast/surface/detail/form_sign.h"
#include "raycast/surface/detail/nearest_t.h"
#include "raycast/surface/form_range.h"
#include "raycast/surface/kind.h"

namespace csgcast {
namespace {

Vector plane_gradient(const Surface& surface, const Frame&, Point) {
  using Form = QuadricForm;
  return {surface.local[Form::x], surface.local[Form::y], surface.local[Form::z]};
}

}  // namespace

const SurfaceKind plane_kind{.name = "plane",
                             .most_crossings = 1,
                             .takes = [](const QuadricForm& form) { return form.is_plane(); },
                             .in_double = detail::filtered_plane,
                             .in_twofold = detail::twofold_plane,
                             .exactly = detail::exact_crossings,
                             .uncertified = detail::uncertified_plane,
                             .twofold_root = detail::twofold_plane_root,
                             .exact_root = detail::exact_root,
                             .nearest_t = detail::nearest_t,
                             .exact_nearest_t = detail::exact_nearest_t,
                             .sign_at = detail::form_sign_at,
                             .sides_in = detail::sides_by_form,
                             .has_lanes = true,
                             .gradient = plane_gradient};

}  // namespace csgcast
