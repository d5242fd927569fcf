// SPDX-License-Identifier: MIT
#include "csg/solid/detail/form_bounds.h"
#include "csg/solid/detail/leaf_forms.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/primitives.h"

namespace csgcast {

Solid quadric(const std::array<double, 6>& a, Vector b, double c, Digits digits) {
  detail::require_finite("quadric", {a[0], a[1], a[2], a[3], a[4], a[5], b.x, b.y, b.z, c});
  QuadricForm f;
  for (std::size_t term = QuadricForm::xx; term <= QuadricForm::zz; ++term) f.coefficient[term] = a[term];
  for (std::size_t term = QuadricForm::xy; term <= QuadricForm::yz; ++term)
    f.coefficient[term] = Dyadic(a[term]).scaled(1);
  for (std::size_t axis = 0; axis < 3; ++axis) f.coefficient[QuadricForm::x + axis] = b[axis];
  f.coefficient[QuadricForm::one] = c;

  if (f.is_constant()) return c <= 0 ? Solid::everything() : Solid();
  if (f.is_plane()) return Solid::leaf(detail::halfspace_shape(std::move(f), digits));
  LeafShape shape;
  shape.kind = LeafKind::quadric;
  shape.bounds = detail::bounds(f);
  if (shape.bounds.is_null()) return {};
  shape.error.axes = {};
  shape.error.digits = digits;
  shape.error.errors.push_back(detail::coefficient_error(f, digits));
  shape.forms.push_back(f);
  return Solid::leaf(std::move(shape));
}

}  // namespace csgcast
