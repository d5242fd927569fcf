// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, by including itself.
#include "raycast/detail/lanes.h"

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raycast/detail/lanes.cpp"
// What is left out would only repeat its neighbours.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raycast/detail/lane_line-inl.h"
// The others build on it.
#include "raycast/detail/lane_events-inl.h"
#include "raycast/detail/lane_hits-inl.h"
#include "raycast/detail/lane_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

template <class D>
HWY_INLINE void set_departures(D d, const LaneRays& rays, std::size_t first, std::size_t count,
                               Departures<D>& departures) {
  const BitsOf<D> bits;
  HWY_ALIGN std::uint64_t positive[16];
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
    const std::size_t ray = first + (i < count ? i : count - 1);
    departures.surface[i] = rays.departure[ray];
    positive[i] = rays.departs_positive[ray];
  }
  departures.positive = hn::RebindMask(d, hn::Ne(hn::Load(bits, positive), hn::Zero(bits)));
}

template <class D>
HWY_INLINE void store(D d, hn::Vec<D> v, double* to, std::size_t first, std::size_t count) {
  if (count == hn::Lanes(d)) return hn::StoreU(v, d, to + first);
  HWY_ALIGN double buffer[16];
  hn::Store(v, d, buffer);
  std::memcpy(to + first, buffer, count * sizeof(double));
}

template <class D, Wanted wanted>
HWY_INLINE void cast(const Scene& scene, const CellData& cells, const LaneRays& rays, const LaneHits& hits,
                     LaneCounts& counts) {
  const D d;
  const BitsOf<D> bits;
  const std::size_t lanes = hn::Lanes(d);
  LineLanes<D> line;
  Departures<D> departures;
  Walk<D, wanted> walk(cells, line, rays.departure != nullptr ? &departures : nullptr, counts);
  for (std::size_t first = 0; first < rays.count; first += lanes) {
    const std::size_t count = HWY_MIN(lanes, rays.count - first);
    set_line(d, scene.frame(), rays, first, count, line);
    prepare_walk(d, cells, rays, first, count, line);
    if (rays.departure != nullptr) set_departures(d, rays, first, count, departures);
    walk.run(hn::FirstN(d, count));
    counts.rays += count;
    ++counts.packets;

    HWY_ALIGN std::uint64_t slots[16];
    HWY_ALIGN std::uint64_t rises[16];
    hn::Store(walk.slot(), bits, slots);
    hn::Store(walk.rises(), bits, rises);
    auto flagged = walk.flagged();
    const auto found = hn::AndNot(flagged, walk.found());
    if constexpr (wanted == Wanted::first) {
      if (!hn::AllFalse(d, found)) {
        hn::Vec<D> t;
        Triples<hn::Vec<D>> place, normal;
        const auto is_rising = hn::RebindMask(d, hn::Ne(walk.rises(), hn::Zero(bits)));
        const bool wants_faces = hits.point[0] != nullptr;
        flagged = hn::Or(flagged, tell_hits(d, scene, cells, line, found, slots, is_rising, walk.inside(), wants_faces,
                                            t, place, normal));
        store(d, t, hits.t, first, count);
        if (wants_faces) {
          const hn::Vec<D> of[6] = {place.x, place.y, place.z, normal.x, normal.y, normal.z};
          for (std::size_t i = 0; i < 3; ++i) {
            store(d, of[i], hits.point[i], first, count);
            store(d, of[3 + i], hits.normal[i], first, count);
          }
        }
      }
    }
    HWY_ALIGN std::uint8_t of_flagged[8];
    HWY_ALIGN std::uint8_t of_found[8];
    HWY_ALIGN std::uint8_t of_inside[8];
    hn::StoreMaskBits(d, flagged, of_flagged);
    hn::StoreMaskBits(d, found, of_found);
    hn::StoreMaskBits(d, walk.inside(), of_inside);
    for (std::size_t i = 0; i < count; ++i) {
      const auto has = [i](const std::uint8_t* mask) { return ((mask[0] >> i) & 1) != 0; };
      const LaneFate hit = has(of_inside) ? LaneFate::entry : LaneFate::exit;
      counts.flagged += has(of_flagged) ? 1 : 0;
      hits.fate[first + i] = has(of_flagged) ? LaneFate::flagged : has(of_found) ? hit : LaneFate::miss;
      if (hits.slot != nullptr) {
        hits.slot[first + i] = static_cast<std::uint32_t>(slots[i]);
        hits.rises[first + i] = rises[i] != 0 ? 1 : 0;
      }
    }
  }
}

using Packet = hn::CappedTag<double, 8>;
using Single = hn::CappedTag<double, 1>;

void first_hits(const Scene& scene, const CellData& cells, const LaneRays& rays, const LaneHits& hits,
                LaneCounts& counts) {
  cast<Packet, Wanted::first>(scene, cells, rays, hits, counts);
}

void first_hits_single(const Scene& scene, const CellData& cells, const LaneRays& rays, const LaneHits& hits,
                       LaneCounts& counts) {
  cast<Single, Wanted::first>(scene, cells, rays, hits, counts);
}

void any_hits(const Scene& scene, const CellData& cells, const LaneRays& rays, const LaneHits& hits,
              LaneCounts& counts) {
  cast<Packet, Wanted::any>(scene, cells, rays, hits, counts);
}

void any_hits_single(const Scene& scene, const CellData& cells, const LaneRays& rays, const LaneHits& hits,
                     LaneCounts& counts) {
  cast<Single, Wanted::any>(scene, cells, rays, hits, counts);
}

LaneCode lane_code(std::string_view name) {
  return {name, hn::Lanes(Packet()), first_hits, first_hits_single, any_hits, any_hits_single};
}

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace csgcast::detail {

std::span<const LaneCode> lane_codes() {
  static const std::vector<LaneCode> codes = [] {
    std::vector<LaneCode> found;
    const auto supported = hwy::SupportedTargets();
#if HWY_TARGETS & HWY_AVX3
    if ((supported & HWY_AVX3) != 0) found.push_back(N_AVX3::lane_code("AVX-512"));
#endif
#if HWY_TARGETS & HWY_AVX2
    if ((supported & HWY_AVX2) != 0) found.push_back(N_AVX2::lane_code("AVX2"));
#endif
#if HWY_TARGETS & HWY_SSE4
    if ((supported & HWY_SSE4) != 0) found.push_back(N_SSE4::lane_code("SSE4"));
#endif
    found.push_back(HWY_STATIC_DISPATCH(lane_code)("baseline"));
    return found;
  }();
  return codes;
}

}  // namespace csgcast::detail
#endif
