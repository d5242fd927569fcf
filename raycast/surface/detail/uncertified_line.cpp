// SPDX-License-Identifier: MIT
#include "raycast/surface/detail/uncertified_line.h"

#include <cmath>
#include <utility>

#include "raycast/surface/detail/line_crossings.h"
#include "raycast/surface/detail/quadric_line.h"

namespace csgcast::detail {
namespace {

LineCrossings plane(const LineFrame& line, const Surface& surface) {
  const PlaneOnLine f = plane_on_line(line, surface);
  return f.slope == 0 ? none(f.value >= 0) : one(-f.value / f.slope, f.slope < 0);
}

LineCrossings quadric(const LineFrame& line, const Surface& surface) {
  const QuadricOnLine f = quadric_on_line(line, surface);
  const double discriminant = f.b * f.b - f.a * f.c;
  if (f.a == 0) return f.b == 0 ? none(f.c >= 0) : one(f.origin - f.c / (2 * f.b), f.b < 0);
  if (!(discriminant > 0)) return none(f.a > 0);
  const double root = std::sqrt(discriminant);
  const double sum = f.b < 0 ? root - f.b : -(f.b + root);
  LineCrossings found = none(f.a > 0);
  found.tau = {f.origin + f.c / sum, f.origin + sum / f.a};
  if (found.tau[0] > found.tau[1]) std::swap(found.tau[0], found.tau[1]);
  found.count = found.tau[0] < found.tau[1] ? 2 : 0;
  return found;
}

LineCrossings departing(const Line& line, const Surface& surface) {
  const bool positive = line.departure_side == Sense::positive;
  if (surface.kind == SurfaceKind::plane) {
    const double slope = plane_on_line(line.in_frame, surface).slope;
    return none(slope == 0 ? positive : slope > 0);
  }
  const QuadricOnLine f = quadric_on_line(line.in_frame, surface);
  if (f.a == 0 || (f.a > 0) == positive) return none(positive);
  const double start = -line.in_frame.shift;
  return one(std::fmax(2 * (f.origin - f.b / f.a) - start, start), positive);
}

}  // namespace

LineCrossings uncertified_crossings(const Line& line, SurfaceId id, const Surface& surface, ExactCalls&) {
  if (id == line.departure) return departing(line, surface);
  return surface.kind == SurfaceKind::plane ? plane(line.in_frame, surface) : quadric(line.in_frame, surface);
}

}  // namespace csgcast::detail
