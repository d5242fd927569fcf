// SPDX-License-Identifier: MIT
#include "raycast/surface/plane/plane.h"

#include "raycast/surface/detail/twofold_form.h"

namespace csgcast::detail {
namespace {

using Form = QuadricForm;

// Computes -v / s, with v and s in twofold arithmetic.
std::optional<TwofoldRoot> root_of(const LineFrame& line, const Surface& plane) {
  const TwofoldVector normal = first_degree(plane);
  const double e = longest(line.direction);
  const TwofoldVector start = start_of(line, plane);
  const double size = longest(start);
  const TwofoldBounded slope{dot(normal, line.direction), 24 * uu * plane.first_degree * e + underflow};
  if (!slope.is_certain()) return std::nullopt;
  const TwofoldBounded value{dot(normal, start) + coefficient(plane, Form::one),
                             (32 * uu * (plane.first_degree * size + plane.constant) +
                              plane.first_degree * (line.near_low_error + 4 * uu * size)) *
                                     rounding_of_bounds +
                                 underflow};
  const TwofoldBounded ratio = quotient(value, slope);
  return TwofoldRoot{-ratio.value, ratio.error};
}

}  // namespace

std::optional<LineCrossings> twofold_plane(const Line& line, SurfaceId id, const Surface& plane) {
  if (is_beyond_twofold(line, id, plane)) return std::nullopt;
  const std::optional<TwofoldRoot> root = root_of(line.in_frame, plane);
  if (!root) return std::nullopt;
  LineCrossings found;
  found.count = 1;
  found.positive_before = dot(first_degree(plane), line.in_frame.direction).high < 0;
  report(found, 0, *root);
  return found;
}

std::optional<TwofoldRoot> twofold_plane_root(const Line& line, const CrossingView& crossing) {
  if (is_beyond_twofold(line, crossing.id, *crossing.surface)) return std::nullopt;
  return root_of(line.in_frame, *crossing.surface);
}

}  // namespace csgcast::detail
