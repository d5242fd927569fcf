// SPDX-License-Identifier: MIT
#include "shade/trace/detail/edges.h"

#include <algorithm>
#include <cmath>

namespace csgcast::detail {
namespace {

// A place off the tangent plane of its neighbour by more than this many spacings is on another fold: a smooth surface
// seen at 84 degrees from head-on is off by less than ten unless its radius is below five spacings.
constexpr double most_spacings_off = 10;

double off_tangent_plane(const Sight& a, const Sight& b) { return std::fabs(dot(a.normal, b.point - a.point)); }

}  // namespace

bool is_edge(const Sight& a, const Sight& b, double spacing) {
  if (a.leaf.valid() != b.leaf.valid()) return true;
  if (!a.leaf.valid()) return false;
  if (a.surface != b.surface || a.part != b.part || a.look != b.look) return true;
  return std::min(off_tangent_plane(a, b), off_tangent_plane(b, a)) > most_spacings_off * spacing;
}

Rgb paper(const Sight& sight, Rgb color) {
  if (!sight.leaf.valid()) return {1, 1, 1};
  // The tint keeps the colour's hue at an even lightness.
  const double brightest = std::max({color.r, color.g, color.b, 1e-3});
  const Rgb hue = (1 / brightest) * color;
  const double light = 0.35 + 0.6 * std::clamp(sight.facing, 0.0, 1.0);
  constexpr double tint = 0.25;
  return light * Rgb{1 - tint + tint * hue.r, 1 - tint + tint * hue.g, 1 - tint + tint * hue.b};
}

}  // namespace csgcast::detail
