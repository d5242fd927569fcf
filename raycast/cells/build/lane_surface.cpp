// SPDX-License-Identifier: MIT
#include "raycast/cells/build/lane_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "csg/base/length.h"
#include "csg/exact/quadric_form.h"
#include "raycast/cells/build/cell_data.h"
#include "raycast/surface/kind.h"

// From the constants here lanes know what is certain. The constants are valid for rays whose point near the frame's
// center lies within |q| <= 4, and for events within |tau| <= 8 of it. They are derived in docs/accuracy.md, "Lanes".

namespace csgcast::detail {
namespace {

using Form = QuadricForm;
constexpr double u = 0x1p-53;

// Makes a plane that is square to an axis of turned cells up to rounding. Returns `undecided` if the plane is not.
LaneSurface nearly_square_plane(const CellForm& turned) {
  LaneSurface lane;
  const Vector n{turned.c[Form::x], turned.c[Form::y], turned.c[Form::z]};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double size = std::fabs(n[axis]);
    const double rest = std::fmax(std::fabs(n[(axis + 1) % 3]), std::fabs(n[(axis + 2) % 3]));
    const double place = -turned.c[Form::one] / n[axis];
    if (rest > 24 * u * size || !(std::fabs(place) < 1)) continue;
    lane.kind = static_cast<LaneSurface::Kind>(axis);
    lane.c = {place, n[axis] > 0 ? 1.0 : -1.0};
  }
  return lane;
}

LaneSurface plane(const Surface& surface, const CellForm* turned) {
  const auto& k = surface.local;
  LaneSurface lane;
  const Vector n{k[Form::x], k[Form::y], k[Form::z]};
  const double w = k[Form::one];
  if (turned != nullptr) {
    lane = nearly_square_plane(*turned);
    if (lane.kind != LaneSurface::Kind::undecided) return lane;
  }
  for (std::size_t axis = 0; turned == nullptr && axis < 3; ++axis) {
    const double size = std::fabs(n[axis]);
    if (size != longest(n) || surface.first_degree != size) continue;
    lane.kind = static_cast<LaneSurface::Kind>(axis);
    lane.c = {-w / n[axis], n[axis] > 0 ? 1.0 : -1.0};
    // Farther out the bounds would not be valid, and no code looks at planes there.
    if (!(std::fabs(lane.c[0]) < 1)) lane.kind = LaneSurface::Kind::undecided;
    return lane;
  }
  lane.kind = LaneSurface::Kind::plane;
  const double slack = 4 * u * (264 * surface.first_degree + 12 * surface.constant);
  const double value_error = u * (160 * surface.first_degree + 12 * surface.constant);
  lane.c = {n.x, n.y, n.z, w, slack, value_error};
  return lane;
}

// The difference between a form's second degree and `square` times the given shares of x², y² and z². It is the sum of
// the magnitudes of all coefficients, in units of `square`.
double unevenness(const Surface::Coefficients& k, double square, std::array<double, 3> shares) {
  double sum = std::fabs(k[Form::xy]) + std::fabs(k[Form::xz]) + std::fabs(k[Form::yz]);
  for (std::size_t i = 0; i < 3; ++i) sum += std::fabs(k[Form::xx + i] - shares[i] * square);
  return sum / std::fabs(square);
}

// What coordinates are off counts for more than the radius of a smaller sphere: docs/accuracy.md, "Lanes".
constexpr double tiny_radius = 0x1p-45;

LaneSurface sphere(const Surface& surface) {
  const auto& k = surface.local;
  LaneSurface lane;
  const double a = k[Form::xx];
  if (a == 0) return lane;
  const Vector to_center = (-0.5 / a) * Vector{k[Form::x], k[Form::y], k[Form::z]};
  const Vector center = surface.center + to_center;
  const double radius_squared = dot(to_center, to_center) - k[Form::one] / a;
  if (!(radius_squared > 0) || !(radius_squared < 1) || !(longest(center) < 1)) return lane;
  // A sphere that was turned is not exactly a sphere. The discriminant's bound has to cover that.
  const double radius = std::sqrt(radius_squared);
  const double reach = radius + longest(to_center);
  const double uneven = unevenness(k, a, {1, 1, 1});
  // Without the first condition a cone could pass for a tiny sphere.
  if (uneven > 64 * u || uneven * 3 * reach * reach > 64 * u * (radius + tiny_radius)) return lane;
  lane.kind = LaneSurface::Kind::sphere;
  const double least = std::fmax(0x1p-16 * radius_squared, 0x1p-43 * radius) + tiny_radius * tiny_radius;
  lane.c = {center.x, center.y, center.z, radius_squared, least, a > 0 ? 1.0 : -1.0};
  return lane;
}

// Makes a cylinder x² + y² = r² about a center, or the same along another axis. In turned cells it is one up to
// rounding.
LaneSurface cylinder(const CellForm& form, bool is_turned, std::size_t axis) {
  const auto& k = form.c;
  LaneSurface lane;
  const std::size_t i = (axis + 1) % 3;
  const std::size_t j = (axis + 2) % 3;
  const double a = k[Form::xx + i];
  if (a == 0) return lane;
  std::array<double, 3> shares{1, 1, 1};
  shares[axis] = 0;
  const double uneven = unevenness(k, a, shares);
  const double lean = std::fabs(k[Form::x + axis] / a);
  if (is_turned ? uneven + lean > 64 * u : uneven + lean != 0) return lane;
  Vector to_center;
  to_center[i] = -0.5 / a * k[Form::x + i];
  to_center[j] = -0.5 / a * k[Form::x + j];
  const Vector center = form.center + to_center;
  const double radius_squared = dot(to_center, to_center) - k[Form::one] / a;
  if (!(radius_squared > 0x1p-40) || !(radius_squared < 1) || !(longest(center) < 1)) return lane;
  double least = 0x1p-17 * radius_squared;
  if (is_turned) {
    // Everything in the cells is within 2.5 of the center of the form.
    const double off = 6.25 * (uneven / u + 4) + 2.5 * (lean / u + 1) + 400 * std::sqrt(radius_squared);
    least = std::fmax(least, 0x1p-30 * off * off);
    if (least > 0x1p-6 * radius_squared) return lane;
  }
  lane.kind = static_cast<LaneSurface::Kind>(static_cast<std::size_t>(LaneSurface::Kind::cylinder_x) + axis);
  lane.c = {center.x, center.y, center.z, radius_squared, least, a > 0 ? 1.0 : -1.0};
  return lane;
}

// Makes a cone, hyperboloid or spheroid x² + y² - κ z² = ρ about a center, or the same along another axis.
LaneSurface revolved(const Surface& surface, std::size_t axis) {
  const auto& k = surface.local;
  LaneSurface lane;
  const double a = k[Form::xx + (axis + 1) % 3];
  const double b = k[Form::xx + axis];
  if (surface.is_mixed || a == 0 || b == 0 || k[Form::xx + (axis + 2) % 3] != a) return lane;
  const double kappa = -b / a;
  Vector to_center = (-0.5 / a) * Vector{k[Form::x], k[Form::y], k[Form::z]};
  to_center[axis] = -0.5 / b * k[Form::x + axis];
  const Vector center = surface.center + to_center;
  if (!(std::fabs(kappa) < 16) || !(longest(to_center) < 1) || !(longest(center) < 1)) return lane;
  const double along = to_center[axis] * to_center[axis];
  const double across =
      to_center[(axis + 1) % 3] * to_center[(axis + 1) % 3] + to_center[(axis + 2) % 3] * to_center[(axis + 2) % 3];
  const double constant = k[Form::one] / a;
  const double rho = across - kappa * along - constant;
  const double size = across + std::fabs(kappa) * along + std::fabs(constant);
  // Smaller quadrics would leave too many rays to the caster.
  if (!(std::fmax(std::fabs(kappa) * along, std::fabs(rho)) > 0x1p-32)) return lane;
  // The last term makes sure that lanes are certain only of what the filter about surface.center knows as well.
  const double filter = 0x1p-54 * std::fmax(1, std::fabs(kappa)) * std::sqrt(longest(to_center) + 0x1p-16);
  const double off = 32 * u * size + 4 * u * std::fabs(rho) + filter;
  lane.kind = static_cast<LaneSurface::Kind>(static_cast<std::size_t>(LaneSurface::Kind::revolved_x) + axis);
  lane.c = {center.x, center.y, center.z, kappa, rho, std::copysign(off, a)};
  return lane;
}

// True if a line may be certain to meet the surface twice within `greatest_slack`.
bool may_have_twins(const LaneSurface& surface, bool departs) {
  // If the crossings of a round surface are certain, they are at least 2^-11 of its radius apart.
  constexpr double least_radius = 0x1p14 * greatest_slack;
  // The crossings of a quadric about an axis are at least 2^-29 apart. Rays that depart treat it as a general quadric.
  return surface.kind == LaneSurface::Kind::quadric || (departs && is_revolved(surface.kind)) ||
         (is_round(surface.kind) && surface.c[3] < least_radius * least_radius);
}

}  // namespace

void Tolerance::allow_for(const LaneSurface& surface) {
  const auto widen = [this](double wanted) { slack = std::max(slack, static_cast<float>(wanted)); };
  if (is_round(surface.kind)) widen(round_slack);
  if (is_revolved(surface.kind)) widen(revolved_slack);
  may_have_twins = may_have_twins || detail::may_have_twins(surface, false);
  departing_may_have_twins = departing_may_have_twins || detail::may_have_twins(surface, true);
}

double revolved_off(const LaneSurface& surface, const CellBox& box) {
  // Points farther than this from its center do not matter.
  constexpr double greatest_reach = 4;
  double squared = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double part = std::fmax(surface.c[axis] - box.lower[axis], box.upper[axis] - surface.c[axis]);
    squared += part * part;
  }
  // Cells are treated as wider than they are.
  const double reach = std::fmin(std::sqrt(squared) + 0x1p-20, greatest_reach);
  const double unit = u * std::fmax(1, std::fabs(surface.c[3]));
  const double off = unit * (64 * reach + 704) * reach + std::fabs(surface.c[5]);
  return std::copysign(off, surface.c[5]);
}

LaneSurface make_lane_surface(const Surface& surface, const CellForm* turned) {
  if (!surface.in_range || !surface.kind->has_lanes) return {};
  if (surface.is_plane) return plane(surface, turned);
  const LaneSurface round = sphere(surface);
  if (round.kind != LaneSurface::Kind::undecided) return round;
  const CellForm form = turned != nullptr ? *turned : CellForm{surface.local, surface.center};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const LaneSurface lane = cylinder(form, turned != nullptr, axis);
    if (lane.kind != LaneSurface::Kind::undecided) return lane;
  }
  LaneSurface lane;
  // The bounds assume that the centers of quadrics are within the frame's cube.
  if (!(longest(surface.center) < 0.75)) return lane;
  for (std::size_t axis = 0; turned == nullptr && axis < 3; ++axis) {
    lane = revolved(surface, axis);
    if (lane.kind != LaneSurface::Kind::undecided) return lane;
  }
  lane.kind = LaneSurface::Kind::quadric;
  return lane;
}

}  // namespace csgcast::detail
