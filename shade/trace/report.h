// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "raycast/packets/packet_caster.h"

namespace csgcast {

/// Rays by kind.
struct RayCounts {
  std::uint64_t primary = 0;
  std::uint64_t shadow = 0;
  std::uint64_t reflection = 0;
  std::uint64_t transmission = 0;
};

/// Rays that were not traced, by reason.
struct SkipCounts {
  std::uint64_t primary_beyond_bounds = 0;    ///< the pixel is outside the outline of the solid's bounds
  std::uint64_t primary_like_neighbours = 0;  ///< the pixel looks like those around it (Sampling::adaptive)
  std::uint64_t shadow_facing_away = 0;       ///< the light is behind the surface
  std::uint64_t shadow_without_effect = 0;    ///< the light would add nothing even where nothing blocks it
  std::uint64_t shadow_leading_away = 0;      ///< the solid lies behind the surface: nothing can block the light
  std::uint64_t reflection_leading_away = 0;  ///< likewise: the ray sees the background
  std::uint64_t transmission_leading_away = 0;
  std::uint64_t reflection_below_cutoff = 0;  ///< min_contribution is more than what the ray could bring
  std::uint64_t transmission_below_cutoff = 0;
  std::uint64_t depth_limit = 0;  ///< rays that got the background because of max_depth
};

/// What a picture cost.
struct RenderReport {
  RayCounts rays;
  SkipCounts skipped;
  std::uint64_t refined_pixels = 0;  ///< those that got all their samples after a first one (Sampling::adaptive)
  std::uint64_t total_reflections =
      0;                     ///< transmission rays that total internal reflection turned into reflection rays
  CasterCounts casts;        ///< of rays one by one
  PacketCounts packets;      ///< of rays in packets
  double cells_seconds = 0;  ///< of the wall clock, cutting the scene into cells
  double seconds = 0;        ///< of the wall clock, tracing
  double cpu_seconds = 0;    ///< of all processors together, tracing

  RenderReport& operator+=(const RenderReport& other);
};

}  // namespace csgcast
