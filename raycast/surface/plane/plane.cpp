// SPDX-License-Identifier: MIT
#include "raycast/surface/plane/plane.h"

#include "csg/exact/quadric_form.h"
#include "raycast/surface/detail/ten_numbers.h"

namespace csgcast {
namespace {

Vector plane_gradient(const Surface& surface, const Frame&, Point) {
  using Form = QuadricForm;
  return {surface.local[Form::x], surface.local[Form::y], surface.local[Form::z]};
}

}  // namespace

constinit const SurfaceKind plane_kind = [] {
  SurfaceKind kind = detail::kind_of_ten_numbers();
  kind.name = "plane";
  kind.most_crossings = 1;
  kind.takes = [](const QuadricForm& form) { return form.is_plane(); };
  kind.in_double = detail::filtered_plane;
  kind.in_twofold = detail::twofold_plane;
  kind.uncertified = detail::uncertified_plane;
  kind.twofold_root = detail::twofold_plane_root;
  kind.gradient = plane_gradient;
  return kind;
}();

}  // namespace csgcast
