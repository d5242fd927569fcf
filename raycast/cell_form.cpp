// SPDX-License-Identifier: MIT
#include "raycast/cell_form.h"

#include <cmath>

#include "raycast/detail/form_range.h"

namespace csgcast {

LocalForm local_form(const CellForm& form, const CellBox& box) {
  using Form = QuadricForm;
  const auto& c = form.c;
  const Vector half = 0.5 * (box.upper - box.lower);
  const Vector p = 0.5 * (box.upper + box.lower) - form.center;
  LocalForm local;
  local.gradient = {2 * c[Form::xx] * p.x + c[Form::xy] * p.y + c[Form::xz] * p.z + c[Form::x],
                    2 * c[Form::yy] * p.y + c[Form::xy] * p.x + c[Form::yz] * p.z + c[Form::y],
                    2 * c[Form::zz] * p.z + c[Form::xz] * p.x + c[Form::yz] * p.y + c[Form::z]};
  local.value = (c[Form::xx] * p.x + c[Form::xy] * p.y + c[Form::xz] * p.z + c[Form::x]) * p.x +
                (c[Form::yy] * p.y + c[Form::yz] * p.z + c[Form::y]) * p.y + (c[Form::zz] * p.z + c[Form::z]) * p.z +
                c[Form::one];
  for (std::size_t i = 0; i < local.bend.size(); ++i) local.bend[i] = c[i];
  const double reach = longest(p) + longest(half);
  double bend = 0;
  for (const double b : local.bend) bend += std::fabs(b);
  const double slope = std::fabs(c[Form::x]) + std::fabs(c[Form::y]) + std::fabs(c[Form::z]);
  // Coordinates up to 8 may be off by 2^-49 each: that moves f by the gradient's bound times as much.
  local.slack =
      detail::form_tolerance * ((bend * reach + slope) * (reach + 8) + bend * reach + std::fabs(c[Form::one])) +
      form.off;
  return local;
}

}  // namespace csgcast
