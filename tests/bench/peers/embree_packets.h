// SPDX-License-Identifier: MIT
#pragma once

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>

#include "raycast/ray.h"

namespace csgcast::bench {

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

/// The rays in single precision, from t = 0 on, nothing hit yet; id is the lane.
template <std::size_t lanes>
void load(std::span<const Ray, lanes> rays, EmbreeRays<lanes>& to) {
  // RTCRay and RTCRay8 have the same members in the same order: floats, or arrays of them.
  const auto base = reinterpret_cast<RTCRayN*>(&to.ray);
  const auto hits = reinterpret_cast<RTCHitN*>(&to.hit);
  for (unsigned lane = 0; lane < lanes; ++lane) {
    RTCRayN_org_x(base, lanes, lane) = static_cast<float>(rays[lane].origin().x);
    RTCRayN_org_y(base, lanes, lane) = static_cast<float>(rays[lane].origin().y);
    RTCRayN_org_z(base, lanes, lane) = static_cast<float>(rays[lane].origin().z);
    RTCRayN_dir_x(base, lanes, lane) = static_cast<float>(rays[lane].direction().x);
    RTCRayN_dir_y(base, lanes, lane) = static_cast<float>(rays[lane].direction().y);
    RTCRayN_dir_z(base, lanes, lane) = static_cast<float>(rays[lane].direction().z);
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
