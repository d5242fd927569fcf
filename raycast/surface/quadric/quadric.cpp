// SPDX-License-Identifier: MIT
#include "raycast/surface/quadric/quadric.h"

#include <cmath>
#include <cstddef>

#include "csg/exact/quadric_form.h"
#include "raycast/surface/detail/ten_numbers.h"

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

constinit const SurfaceKind quadric_kind = [] {
  SurfaceKind kind = detail::kind_of_ten_numbers();
  kind.name = "quadric";
  kind.most_crossings = 2;
  kind.takes = [](const QuadricForm& form) { return !form.is_plane(); };
  kind.in_double = detail::filtered_quadric;
  kind.in_twofold = detail::twofold_quadric;
  kind.uncertified = detail::uncertified_quadric;
  kind.twofold_root = detail::twofold_quadric_root;
  kind.gradient = quadric_gradient;
  return kind;
}();

}  // namespace csgcast
