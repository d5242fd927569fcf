// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, by including itself.
#include "raycast/detail/lanes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raycast/detail/lanes.cpp"
// What is left out would only repeat its neighbours.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "csg/vector_lanes-inl.h"
#include "raycast/detail/lane_line-inl.h"
// The others build on it.
#include "raycast/detail/lane_events-inl.h"
#include "raycast/detail/lane_hits-inl.h"
#include "raycast/detail/lane_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

template <class D>
HWY_INLINE void set_departures(D d, const RayArrays& rays, std::size_t first, std::size_t count,
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
HWY_INLINE bool has(D, const std::uint8_t* mask, std::size_t lane) {
  return ((mask[0] >> lane) & 1) != 0;
}

/// What a packet's rays found, in memory. A bit a lane in masks.
struct Outcome {
  HWY_ALIGN std::uint64_t slots[16];
  HWY_ALIGN std::uint64_t rises[16];
  std::uint8_t left[8];
  std::uint8_t found[8];
  std::uint8_t inside[8];
  std::uint8_t second[8];
};

/// Whose faces the packet's hits are. Lanes whose look or leaf depends on more than the cell are left.
template <class D>
HWY_INLINE void store_owners(D d, const CellData& cells, const LaneHits& hits, std::size_t first, std::size_t count,
                             Outcome& outcome) {
  const FaceArrays& faces = hits.faces;
  for (std::size_t i = 0; i < count; ++i) {
    if (!has(d, outcome.found, i)) continue;
    const Slot& slot = cells.slots[outcome.slots[i]];
    faces.surface[first + i] = slot.surface;
    faces.comes_positive[first + i] = outcome.rises[i] != 0 ? 0 : 1;
    if (hits.root != nullptr) hits.root[first + i] = has(d, outcome.second, i) ? 1 : 0;
    if (faces.look == nullptr) continue;
    faces.look[first + i] = slot.look.index();
    if (faces.leaf != nullptr) faces.leaf[first + i] = slot.leaf.index();
    const bool is_known = slot.look.valid() && (faces.leaf == nullptr || slot.leaf.valid());
    if (!is_known) outcome.left[0] = static_cast<std::uint8_t>(outcome.left[0] | (1u << i));
  }
}

/// A byte of 1 or 0 for each of eight bits, the lowest first.
HWY_INLINE std::uint64_t bytes_of(unsigned bits) {
  // Each byte gets all bits and keeps its own; then whatever is left of it moves to the byte's lowest bit.
  const std::uint64_t own = (bits & 0xffu) * 0x0101010101010101u & 0x8040201008040201u;
  return ((own + 0x7f7f7f7f7f7f7f7fu) | own) >> 7 & 0x0101010101010101u;
}

HWY_INLINE void store_states(const LaneHits& hits, std::size_t first, std::size_t count, const Outcome& outcome,
                             PacketCounts& counts) {
  const unsigned found = outcome.found[0];
  const unsigned inside = outcome.inside[0];
  // FaceArrays::entry is 1, exit 2.
  const std::uint64_t states = bytes_of(found) + bytes_of(found & ~inside);
  std::memcpy(hits.faces.state + first, &states, count);
  for (unsigned left = outcome.left[0]; left != 0; left &= left - 1) {
    hits.left->push_back(static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(__builtin_ctz(left)));
    ++counts.flagged;
  }
}

/// t of the packet's hits, and places and normals if they are wanted. Returns the lanes that are left.
template <class D>
HWY_INLINE hn::Mask<D> store_faces(D d, const Scene& scene, const CellData& cells, const LineLanes<D>& line,
                                   hn::Mask<D> found, hn::Mask<D> inside, Outcome& outcome, std::size_t first,
                                   std::size_t count, const LaneHits& hits) {
  const BitsOf<D> bits;
  hn::Vec<D> t;
  hn::Mask<D> second;
  Triples<hn::Vec<D>> place, normal;
  const auto rises = hn::RebindMask(d, hn::Ne(hn::Load(bits, outcome.rises), hn::Zero(bits)));
  const bool wants_faces = hits.faces.point[0] != nullptr;
  const auto left =
      tell_hits(d, scene, cells, line, found, outcome.slots, rises, inside, wants_faces, t, second, place, normal);
  hn::StoreMaskBits(d, second, outcome.second);
  store_lanes(d, t, hits.faces.t + first, count);
  if (wants_faces) {
    store_lanes(d, place, hits.faces.point, first, count);
    store_lanes(d, normal, hits.faces.normal, first, count);
  }
  return left;
}

/// Takes the next packet's lines through the cells.
template <class D, Wanted wanted>
HWY_INLINE void walk_packet(D d, const Scene& scene, const CellData& cells, const RayArrays& rays, std::size_t first,
                            std::size_t count, LineLanes<D>& line, Walk<D, wanted>& walk, PacketCounts& counts) {
  set_line(d, scene.frame(), rays, first, count, line);
  prepare_walk(d, cells, rays, first, count, line);
  walk.run(hn::FirstN(d, count));
  counts.rays += count;
  ++counts.packets;
}

template <class D, Wanted wanted>
void cast(const Scene& scene, const CellData& cells, const RayArrays& rays, const LaneHits& hits,
          PacketCounts& counts) {
  const D d;
  const BitsOf<D> bits;
  const std::size_t lanes = hn::Lanes(d);
  LineLanes<D> line;
  Departures<D> departures;
  Outcome outcome{};
  Walk<D, wanted> walk(cells, line, rays.departure != nullptr ? &departures : nullptr, nullptr, counts);
  for (std::size_t first = 0; first < rays.count; first += lanes) {
    const std::size_t count = HWY_MIN(lanes, rays.count - first);
    if (rays.departure != nullptr) set_departures(d, rays, first, count, departures);
    walk_packet(d, scene, cells, rays, first, count, line, walk, counts);
    auto left = walk.flagged();
    const auto found = hn::AndNot(left, walk.found());
    const bool any_found = !hn::AllFalse(d, found);
    hn::StoreMaskBits(d, found, outcome.found);
    if constexpr (wanted == Wanted::first) {
      if (any_found) {
        hn::Store(walk.slot(), bits, outcome.slots);
        hn::Store(walk.rises(), bits, outcome.rises);
        left = hn::Or(left, store_faces(d, scene, cells, line, found, walk.inside(), outcome, first, count, hits));
      }
    }
    hn::StoreMaskBits(d, left, outcome.left);
    hn::StoreMaskBits(d, walk.inside(), outcome.inside);
    if constexpr (wanted == Wanted::first) {
      if (any_found) store_owners(d, cells, hits, first, count, outcome);
    }
    store_states(hits, first, count, outcome, counts);
  }
}

/// t of the ends of a packet's rays, the first of all rays, then the second, ..
template <class D>
HWY_INLINE void tell_ends(D d, const Scene& scene, const CellData& cells, const LineLanes<D>& line,
                          const LaneEnds& found, std::size_t count, LaneLists& lists) {
  const BitsOf<D> bits;
  const std::size_t base = lists.ends.size();
  std::size_t start[16];
  std::size_t total = 0;
  std::size_t longest_list = 0;
  for (std::size_t i = 0; i < count; ++i) {
    start[i] = base + total;
    total += found.count[i];
    longest_list = HWY_MAX(longest_list, found.count[i]);
    lists.offsets.push_back(base + total);
  }
  lists.ends.resize(base + total);
  HWY_ALIGN std::uint64_t slots[16];
  HWY_ALIGN std::uint64_t rises[16];
  HWY_ALIGN std::uint64_t there[16];
  HWY_ALIGN double at[16];
  HWY_ALIGN std::uint8_t second[8];
  for (std::size_t k = 0; k < longest_list; ++k) {
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
      there[i] = i < count && k < found.count[i] ? 1 : 0;
      slots[i] = there[i] != 0 ? found.slot[i][k] : 0;
      rises[i] = there[i] != 0 && found.rises[i][k] ? 1 : 0;
    }
    const auto as_mask = [&](const std::uint64_t* values) {
      return hn::RebindMask(d, hn::Ne(hn::Load(bits, values), hn::Zero(bits)));
    };
    const auto hits = as_mask(there);
    hn::Vec<D> t;
    hn::Mask<D> is_second;
    Triples<hn::Vec<D>> place, normal;
    const auto open =
        tell_hits(d, scene, cells, line, hits, slots, as_mask(rises), hits, false, t, is_second, place, normal);
    HWY_ALIGN std::uint8_t open_bits[8];
    hn::StoreMaskBits(d, open, open_bits);
    hn::Store(t, d, at);
    hn::StoreMaskBits(d, is_second, second);
    for (std::size_t i = 0; i < count; ++i) {
      if (there[i] == 0) continue;
      if (has(d, open_bits, i)) lists.is_flagged[lists.is_flagged.size() - count + i] = true;
      lists.ends[start[i] + k] = {at[i], static_cast<std::uint32_t>(slots[i]),
                                  static_cast<std::uint8_t>(has(d, second, i) ? 1 : 0)};
    }
  }
}

template <class D>
void cast_lists(const Scene& scene, const CellData& cells, const RayArrays& rays, LaneLists& lists,
                PacketCounts& counts) {
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  LineLanes<D> line;
  LaneEnds ends;
  Walk<D, Wanted::all> walk(cells, line, nullptr, &ends, counts);
  lists.ends.clear();
  lists.offsets.assign(1, 0);
  lists.starts_inside.clear();
  lists.is_flagged.clear();
  for (std::size_t first = 0; first < rays.count; first += lanes) {
    const std::size_t count = HWY_MIN(lanes, rays.count - first);
    walk_packet(d, scene, cells, rays, first, count, line, walk, counts);
    HWY_ALIGN std::uint8_t flagged[8];
    HWY_ALIGN std::uint8_t inside[8];
    hn::StoreMaskBits(d, walk.flagged(), flagged);
    hn::StoreMaskBits(d, walk.started_inside(), inside);
    for (std::size_t i = 0; i < count; ++i) {
      lists.is_flagged.push_back(has(d, flagged, i));
      lists.starts_inside.push_back(has(d, inside, i));
      counts.flagged += has(d, flagged, i) ? 1 : 0;
      if (has(d, flagged, i)) ends.count[i] = 0;
    }
    tell_ends(d, scene, cells, line, ends, count, lists);
  }
}

template <class D>
LaneFunctions functions() {
  return {cast<D, Wanted::first>, cast<D, Wanted::any>, cast_lists<D>};
}

LaneCode lane_code(std::string_view name) {
  return {name, functions<hn::CappedTag<double, 8>>(), functions<hn::CappedTag<double, 1>>()};
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
