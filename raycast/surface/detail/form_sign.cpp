// SPDX-License-Identifier: MIT
#include "raycast/surface/detail/form_sign.h"

#include <array>
#include <cmath>

#include "csg/exact/quadric_form.h"
namespace csgcast::detail {

int form_sign_at(const Surface& surface, Point p) {
  using Form = QuadricForm;
  const auto& c = surface.world;
  const std::array<double, Form::term_count> term{c[Form::xx] * p.x * p.x, c[Form::yy] * p.y * p.y,
                                                  c[Form::zz] * p.z * p.z, c[Form::xy] * p.x * p.y,
                                                  c[Form::xz] * p.x * p.z, c[Form::yz] * p.y * p.z,
                                                  c[Form::x] * p.x,        c[Form::y] * p.y,
                                                  c[Form::z] * p.z,        c[Form::one]};
  double sum = 0;
  double magnitude = 0;
  for (const double t : term) {
    sum += t;
    magnitude += std::fabs(t);
  }
  // Each term has the rounding of its coefficient, two products and nine additions: (1 + u)^12 - 1 < 13 u. The factor
  // 16 u also covers the rounding of the bound. If the exponents are not in a middle range, a term may have overflowed
  // or underflowed.
  if (surface.in_range && magnitude > 0x1p-900 && magnitude < 0x1p900 && std::fabs(sum) > 0x10p-53 * magnitude)
    return sum > 0 ? 1 : -1;
  return surface.exact.unpacked().at(p).sign();
}

}  // namespace csgcast::detail
