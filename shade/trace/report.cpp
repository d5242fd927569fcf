// SPDX-License-Identifier: MIT
#include "shade/trace/report.h"

namespace csgcast {

RenderReport& RenderReport::operator+=(const RenderReport& other) {
  rays.primary += other.rays.primary;
  rays.shadow += other.rays.shadow;
  rays.reflection += other.rays.reflection;
  rays.transmission += other.rays.transmission;
  skipped.primary_beyond_bounds += other.skipped.primary_beyond_bounds;
  skipped.primary_like_neighbours += other.skipped.primary_like_neighbours;
  skipped.shadow_facing_away += other.skipped.shadow_facing_away;
  skipped.shadow_without_effect += other.skipped.shadow_without_effect;
  skipped.shadow_leading_away += other.skipped.shadow_leading_away;
  skipped.reflection_leading_away += other.skipped.reflection_leading_away;
  skipped.transmission_leading_away += other.skipped.transmission_leading_away;
  skipped.reflection_below_cutoff += other.skipped.reflection_below_cutoff;
  skipped.transmission_below_cutoff += other.skipped.transmission_below_cutoff;
  skipped.depth_limit += other.skipped.depth_limit;
  refined_pixels += other.refined_pixels;
  total_reflections += other.total_reflections;
  casts += other.casts;
  packets += other.packets;
  cells_seconds += other.cells_seconds;
  seconds += other.seconds;
  cpu_seconds += other.cpu_seconds;
  return *this;
}

}  // namespace csgcast
