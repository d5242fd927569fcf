// SPDX-License-Identifier: MIT
#include "shade/trace/report.h"

#include "csg/base/add_members.h"

namespace csgcast {

RenderReport& RenderReport::operator+=(const RenderReport& other) {
  add_members<&RayCounts::primary, &RayCounts::shadow, &RayCounts::reflection, &RayCounts::transmission>(rays,
                                                                                                         other.rays);
  add_members<&SkipCounts::primary_beyond_bounds, &SkipCounts::primary_like_neighbours, &SkipCounts::shadow_facing_away,
              &SkipCounts::shadow_without_effect, &SkipCounts::shadow_leading_away,
              &SkipCounts::reflection_leading_away, &SkipCounts::transmission_leading_away,
              &SkipCounts::reflection_below_cutoff, &SkipCounts::transmission_below_cutoff, &SkipCounts::depth_limit>(
      skipped, other.skipped);
  return add_members<&RenderReport::refined_pixels, &RenderReport::total_reflections, &RenderReport::casts,
                     &RenderReport::packets, &RenderReport::cells_seconds, &RenderReport::seconds,
                     &RenderReport::cpu_seconds>(*this, other);
}

}  // namespace csgcast
