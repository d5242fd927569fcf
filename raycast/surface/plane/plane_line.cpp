// SPDX-License-Identifier: MIT
#include "raycast/surface/plane/plane.h"

#include <cmath>

#include "csg/base/length.h"
#include "csg/exact/quadric_form.h"
#include "raycast/surface/detail/bounded.h"
#include "raycast/surface/detail/line_crossings.h"

namespace csgcast::detail {
namespace {

using Form = QuadricForm;

// f(near + tau d) = value + slope tau.
struct PlaneOnLine {
  double value;
  double slope;
};

PlaneOnLine plane_on_line(const LineFrame& line, const Surface& plane) {
  const Vector normal{plane.local[Form::x], plane.local[Form::y], plane.local[Form::z]};
  return {dot(normal, line.near) + plane.local[Form::one], dot(normal, line.direction)};
}

// Each term has a coefficient's rounding, a product and two additions.
Bounded slope_of(const LineFrame& line, const Surface& plane) {
  return {plane_on_line(line, plane).slope, 5 * unit_roundoff * plane.first_degree * longest(line.direction)};
}

// True if the line is exactly parallel to the plane: then each product has a factor of zero.
bool is_parallel(const LineFrame& line, const Surface& plane) {
  const auto vanishes = [&](Form::Term term, double d) { return plane.local[term] == 0 || d == 0; };
  const Vector d = line.direction;
  return vanishes(Form::x, d.x) && vanishes(Form::y, d.y) && vanishes(Form::z, d.z);
}

std::optional<LineCrossings> crossings(const LineFrame& line, const Surface& plane) {
  if (!plane.in_range || !line.in_range) return std::nullopt;
  const double size = longest(line.near);
  const Bounded slope = slope_of(line, plane);
  // The value has one addition more than the slope, and the error of `near`.
  const PlaneOnLine f = plane_on_line(line, plane);
  const Bounded value{f.value, (6 * unit_roundoff * (plane.first_degree * size + plane.constant) +
                                plane.first_degree * line.near_error) *
                                   rounding_of_bounds};
  if (2 * slope.error < std::fabs(slope.value)) {
    LineCrossings found;
    const double tau = -value.value / slope.value;
    found.few[0] = tau;
    found.error =
        (2 * (value.error + std::fabs(tau) * slope.error) / std::fabs(slope.value) + unit_roundoff * std::fabs(tau)) *
        rounding_of_bounds;
    found.count = 1;
    found.positive_before = slope.value < 0;
    return found;
  }
  if (is_parallel(line, plane) && value.is_certain()) return none(value.value > 0);
  // The line is nearly parallel: a crossing, if there is one, lies out of reach.
  const double farthest = (reach + 2 * size) * slope.most() * rounding_of_bounds;
  if (plane.is_local && line.knows_cube && value.least() > farthest) return none(value.value > 0);
  return std::nullopt;
}

// After the start the ray is on the side of the plane that the slope tells.
std::optional<LineCrossings> after_departure(const Line& line, const Surface& plane) {
  if (!plane.in_range || !line.in_frame.in_range) return std::nullopt;
  const Bounded slope = slope_of(line.in_frame, plane);
  if (slope.is_certain()) return none(slope.value > 0);
  if (!is_parallel(line.in_frame, plane)) return std::nullopt;
  return none(line.departure_side == Sense::positive);
}

}  // namespace

std::optional<LineCrossings> filtered_plane(const Line& line, SurfaceId id, const Surface& plane) {
  return id == line.departure ? after_departure(line, plane) : crossings(line.in_frame, plane);
}

LineCrossings uncertified_plane(const Line& line, SurfaceId id, const Surface& plane) {
  const PlaneOnLine f = plane_on_line(line.in_frame, plane);
  if (id != line.departure) return f.slope == 0 ? none(f.value >= 0) : one(-f.value / f.slope, f.slope < 0);
  return none(f.slope == 0 ? line.departure_side == Sense::positive : f.slope > 0);
}

}  // namespace csgcast::detail
