// SPDX-License-Identifier: MIT
#include "raycast/surface/quadric/quadric.h"

#include <cmath>
#include <cstddef>

#include "csg/exact/quadric_form.h"
#include "raycast/surface/detail/exact_line.h"
#include "raycast/surface/detail/form_sign.h"
#include "raycast/surface/detail/nearest_t.h"
#include "raycast/surface/form_range.h"
#include "raycast/surface/kind.h"

namespace csgcast {
namespace {

Vector quadric_gradient(const Surface& surface, const Frame& frame, Point p) {
  using Form = QuadricForm;
  const auto& c = surface.local;
  Vector q;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    q[axis] = std::ldexp(p[axis] - frame.center[axis], -frame.exponent) - surface.center[axis];
  }
  return {2 * c[Form::xx] * q.x + c[Form::xy] * q.y + c[Form::xz] * q.z + c[Form::x],
          2 * c[Form::yy] * q.y + c[Form::xy] * q.x + c[Form::yz] * q.z + c[Form::y],
          2 * c[Form::zz] * q.z + c[Form::xz] * q.x + c[Form::yz] * q.y + c[Form::z]};
}

}  // namespace

const SurfaceKind quadric_kind{.name = "quadric",
                               .most_crossings = 2,
                               .takes = [](const QuadricForm& form) { return !form.is_plane(); },
                               .in_double = detail::filtered_quadric,
                               .in_twofold = detail::twofold_quadric,
                               .exactly = detail::exact_crossings,
                               .uncertified = detail::uncertified_quadric,
                               .twofold_root = detail::twofold_quadric_root,
                               .exact_root = detail::exact_root,
                               .nearest_t = detail::nearest_t,
                               .exact_nearest_t = detail::exact_nearest_t,
                               .sign_at = detail::form_sign_at,
                               .sides_in = detail::sides_by_form,
                               .has_lanes = true,
                               .gradient = quadric_gradient};

}  // namespace csgcast
