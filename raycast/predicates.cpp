// SPDX-License-Identifier: MIT
#include "raycast/predicates.h"

#include <cmath>

#include "raycast/detail/plane_line.h"
#include "raycast/detail/quadric_line.h"

namespace csgcast {
namespace {

std::weak_ordering by_value(double gap) {
  return gap < 0 ? std::weak_ordering::less : gap > 0 ? std::weak_ordering::greater : std::weak_ordering::equivalent;
}

}  // namespace

int sign_at(const Surface& surface, Point p) {
  using Form = QuadricForm;
  const auto& c = surface.coefficient;
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
  // A coefficient's rounding, two products and nine additions: (1 + u)^12 - 1 < 13 u; 16 u also covers the rounding of
  // the bound. Out of the middle of the exponents under- and overflow may have touched a term.
  if (surface.in_range && magnitude > 0x1p-900 && magnitude < 0x1p900 && std::fabs(sum) > 0x10p-53 * magnitude)
    return sum > 0 ? 1 : -1;
  return surface.exact.at(p).sign();
}

LineCrossings crossings(Line& line, SurfaceId id, const Surface& surface) {
  return surface.kind == SurfaceKind::plane ? detail::plane_crossings(line, id, surface)
                                            : detail::quadric_crossings(line, id, surface);
}

std::weak_ordering order(Line& line, const CrossingView& a, const CrossingView& b) {
  if (a.id == b.id) return a.root <=> b.root;
  const double gap = a.t() - b.t();
  const double error = a.found->error + b.found->error;
  // The subtraction and the addition round by a relative u each; doubling the error covers both.
  if (std::fabs(gap) > 2 * error) return by_value(gap);
  const bool a_is_plane = a.surface->kind == SurfaceKind::plane;
  const bool b_is_plane = b.surface->kind == SurfaceKind::plane;
  if (a_is_plane && b_is_plane) return detail::exact_order(line, a, b);
  if (a_is_plane) return detail::exact_order(line, a, b.t());
  if (b_is_plane) return 0 <=> detail::exact_order(line, b, a.t());
  return by_value(gap);
}

std::weak_ordering order(Line& line, const CrossingView& a, double t) {
  if (std::isinf(t)) return t > 0 ? std::weak_ordering::less : std::weak_ordering::greater;
  const double gap = a.t() - t;
  if (std::fabs(gap) > 2 * a.found->error) return by_value(gap);
  return a.surface->kind == SurfaceKind::plane ? detail::exact_order(line, a, t) : by_value(gap);
}

}  // namespace csgcast
