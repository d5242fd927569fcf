// SPDX-License-Identifier: MIT
#pragma once

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>

#include "tests/support/ray_batch.h"

namespace csgcast::bench {

using test::RayBatch;

/// Embree's calls for 1, 8 and 16 rays at a time, under one name.
template <std::size_t lanes>
using EmbreeRays = std::conditional_t<lanes == 1, RTCRayHit, std::conditional_t<lanes == 8, RTCRayHit8, RTCRayHit16>>;

inline void intersect(RTCScene scene, RTCIntersectContext* context, RTCRayHit& rays) {
  rtcIntersect1(scene, context, &rays);
}

template <class Rays>
void intersect(RTCScene scene, RTCIntersectContext* context, Rays& rays) {
  constexpr std::size_t lanes = std::extent_v<decltype(rays.ray.tfar)>;
  alignas(64) int valid[lanes];
  std::fill(std::begin(valid), std::end(valid), -1);
  if constexpr (lanes == 8) {
    rtcIntersect8(valid, scene, context, &rays);
  } else {
    rtcIntersect16(valid, scene, context, &rays);
  }
}

/// Rays [first, first + lanes) in single precision, from t = 0 on, nothing hit yet; id is the lane.
template <std::size_t lanes>
void load(const RayBatch& rays, std::size_t first, EmbreeRays<lanes>& to) {
  // RTCRay and RTCRay8 have the same members in the same order: floats, or arrays of them.
  const auto base = reinterpret_cast<RTCRayN*>(&to.ray);
  const auto hits = reinterpret_cast<RTCHitN*>(&to.hit);
  const auto copy = [&](const double* from, float* into) {
    for (std::size_t lane = 0; lane < lanes; ++lane) into[lane] = static_cast<float>(from[lane]);
  };
  copy(rays.origin(0, first), &RTCRayN_org_x(base, lanes, 0));
  copy(rays.origin(1, first), &RTCRayN_org_y(base, lanes, 0));
  copy(rays.origin(2, first), &RTCRayN_org_z(base, lanes, 0));
  copy(rays.direction(0, first), &RTCRayN_dir_x(base, lanes, 0));
  copy(rays.direction(1, first), &RTCRayN_dir_y(base, lanes, 0));
  copy(rays.direction(2, first), &RTCRayN_dir_z(base, lanes, 0));
  for (unsigned lane = 0; lane < lanes; ++lane) {
    RTCRayN_tnear(base, lanes, lane) = 0;
    RTCRayN_tfar(base, lanes, lane) = std::numeric_limits<float>::infinity();
    RTCRayN_time(base, lanes, lane) = 0;
    RTCRayN_mask(base, lanes, lane) = ~0U;
    RTCRayN_id(base, lanes, lane) = lane;
    RTCRayN_flags(base, lanes, lane) = 0;
    RTCHitN_geomID(hits, lanes, lane) = RTC_INVALID_GEOMETRY_ID;
  }
}

/// t of the hit of a lane, infinite if there is none.
template <std::size_t lanes>
double hit_t(EmbreeRays<lanes>& rays, unsigned lane) {
  const bool hit = RTCHitN_geomID(reinterpret_cast<RTCHitN*>(&rays.hit), lanes, lane) != RTC_INVALID_GEOMETRY_ID;
  return hit ? static_cast<double>(RTCRayN_tfar(reinterpret_cast<RTCRayN*>(&rays.ray), lanes, lane))
             : std::numeric_limits<double>::infinity();
}

}  // namespace csgcast::bench
