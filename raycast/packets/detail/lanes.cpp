// SPDX-License-Identifier: MIT
// This file is compiled once for each instruction set, by including itself.
#include "raycast/packets/detail/lanes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <vector>

#include "raycast/packets/detail/compress_table.h"
#include "raycast/simd/instruction_set.h"
#include "raycast/simd/lane_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raycast/packets/detail/lanes.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raycast/packets/detail/lane_events-inl.h"
#include "raycast/packets/detail/lane_hits-inl.h"
#include "raycast/packets/detail/lane_line-inl.h"
#include "raycast/packets/detail/lane_log-inl.h"
#include "raycast/packets/detail/lane_walk-inl.h"
#include "raycast/simd/vector_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

/// Packs the low bits of eight bytes, the first byte in the lowest bit.
HWY_INLINE std::uint8_t bits_of(std::uint64_t bytes) {
  // The product moves each byte's bit to its own place in the top byte.
  return static_cast<std::uint8_t>((bytes & 0x0101010101010101u) * 0x0102040810204080u >> 56);
}

/// Makes a byte of 1 or 0 from each of eight bits, the lowest first.
HWY_INLINE std::uint64_t bytes_of(unsigned bits) {
  // Each byte gets all bits and keeps its own. Then its bit is moved to the lowest place in the byte.
  const std::uint64_t own = (bits & 0xffu) * 0x0101010101010101u & 0x8040201008040201u;
  return ((own + 0x7f7f7f7f7f7f7f7fu) | own) >> 7 & 0x0101010101010101u;
}

template <class D>
HWY_INLINE void set_departures(D d, const RayPointers& rays, std::size_t first, std::size_t count,
                               Departures<D>& departures) {
  const hn::Rebind<std::uint32_t, D> half;
  std::uint32_t surfaces[8];
  const std::uint32_t* from = rays.departure + first;
  if (count < hn::Lanes(d)) {
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) surfaces[i] = from[i < count ? i : count - 1];
    from = surfaces;
  }
  departures.surface = hn::PromoteTo(BitsOf<D>(), hn::LoadU(half, from));
  std::uint64_t sides = 0;
  std::memcpy(&sides, rays.departs_positive + first, count);
  const std::uint8_t positive[8] = {bits_of(sides)};
  departures.positive = hn::LoadMaskBits(d, positive);
}

/// Stores the numbers of the first `count` lanes, which are below 2^32, in 32 bits each.
template <class D>
HWY_INLINE void store_ids(D, hn::Vec<BitsOf<D>> ids, std::uint32_t* to, std::size_t count) {
  const hn::Rebind<std::uint32_t, D> half;
  const auto narrow = hn::TruncateTo(half, ids);
  if (count >= hn::Lanes(half)) return hn::StoreU(narrow, half, to);
  std::uint32_t buffer[8];
  hn::StoreU(narrow, half, buffer);
  std::copy_n(buffer, count, to);
}

HWY_INLINE void store_bytes(unsigned bits, std::uint8_t* to, std::size_t count) {
  const std::uint64_t bytes = bytes_of(bits);
  std::memcpy(to, &bytes, count);
}

template <class D>
HWY_INLINE void store_roots(D, hn::Vec<BitsOf<D>> roots, std::uint8_t* to, std::size_t count) {
  HWY_ALIGN std::uint64_t buffer[16];
  hn::Store(roots, BitsOf<D>(), buffer);
  for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<std::uint8_t>(buffer[i]);
}

/// Adds the rays in some lanes to a list.
HWY_INLINE void add_lanes(std::vector<std::uint32_t>& rays, std::size_t first, unsigned lanes) {
  for (; lanes != 0; lanes &= lanes - 1)
    rays.push_back(static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(__builtin_ctz(lanes)));
}

HWY_INLINE void leave(std::vector<std::uint32_t>& left, std::size_t first, unsigned lanes, PacketCounts& counts) {
  add_lanes(left, first, lanes);
  counts.flagged += static_cast<std::uint64_t>(__builtin_popcount(lanes));
}

/// Stores the first hits of a packet's rays. Returns the lanes whose numbers need the scalar code.
template <class D>
HWY_INLINE hn::Mask<D> store_hits(D d, const Scene& scene, const CellData& cells, const LineLanes<D>& line,
                                  const Departures<D>* departures, const Walk<D, Wanted::first>& walk,
                                  hn::Mask<D> found, std::size_t first, std::size_t count, const LaneHits& hits) {
  const FacePointers& faces = hits.faces;
  const BitsOf<D> bits;
  const auto owners = owners_of(d, cells, walk.slot());
  const bool wants_faces = faces.point[0] != nullptr;
  Told<D> told;
  tell_hits(d, scene, line, departures, found, owners.surface, walk.rises(), walk.inside(), wants_faces, hits.rounds,
            told);
  if (hits.rounds) add_lanes(*hits.unrounded, first, lane_bits(d, told.unrounded));
  store_lanes(d, told.t, faces.t + first, count);
  store_ids(d, owners.surface, faces.surface + first, count);
  if (faces.root != nullptr) store_roots(d, told.root, faces.root + first, count);
  if (!wants_faces) return told.left;
  store_lanes(d, told.place, faces.point, first, count);
  store_lanes(d, told.normal, faces.normal, first, count);
  store_bytes(~lane_bits(d, walk.rises()), faces.comes_positive + first, count);
  const auto unknown = hn::Set(bits, LookId().index());
  auto unowned = hn::RebindMask(d, hn::Eq(owners.look, unknown));
  store_ids(d, owners.look, faces.look + first, count);
  if (faces.leaf != nullptr) {
    unowned = hn::Or(unowned, hn::RebindMask(d, hn::Eq(owners.leaf, unknown)));
    store_ids(d, owners.leaf, faces.leaf + first, count);
  }
  add_lanes(*hits.unowned, first, lane_bits(d, hn::AndNot(told.left, hn::And(found, unowned))));
  return told.left;
}

/// Takes the next packet's lines through the cells.
template <class D, Wanted wanted>
HWY_INLINE void walk_packet(D d, const Scene& scene, const CellData& cells, const RayPointers& rays, std::size_t first,
                            std::size_t count, LineLanes<D>& line, Walk<D, wanted>& walk, PacketCounts& counts) {
  counts.rays += count;
  ++counts.packets;
  const auto lanes = hn::FirstN(d, count);
  const auto origin = load_lanes(d, rays.origin, first, count);
  const auto direction = load_lanes(d, rays.direction, first, count);
  // Rays that depart from the solid meet its box, so they are not tested.
  const bool may_pass_by = rays.departure == nullptr && !cells.reaches_beyond;
  if (may_pass_by && hn::AllFalse(d, hn::AndNot(passes_by(d, scene.frame(), cells, origin, direction), lanes)))
    return walk.begin();
  set_line(d, scene.frame(), cells, origin, direction, line);
  prepare_walk(d, cells, rays, first, count, line);
  walk.run(lanes);
}

template <class D, Wanted wanted>
void cast(const Scene& scene, const CellData& cells, const RayPointers& rays, const LaneHits& hits,
          PacketCounts& counts) {
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  LineLanes<D> line;
  line.wants_low = hits.rounds || hits.faces.point[0] != nullptr;
  Departures<D> departures;
  Walk<D, wanted> walk(scene, cells, line, rays.departure != nullptr ? &departures : nullptr, nullptr, counts);
  for (std::size_t first = 0; first < rays.count; first += lanes) {
    const std::size_t count = HWY_MIN(lanes, rays.count - first);
    if (rays.departure != nullptr) set_departures(d, rays, first, count, departures);
    walk_packet(d, scene, cells, rays, first, count, line, walk, counts);
    auto left = walk.flagged();
    const auto found = hn::AndNot(left, walk.found());
    if constexpr (wanted == Wanted::first) {
      if (!hn::AllFalse(d, found)) {
        const auto* const from = rays.departure != nullptr ? &departures : nullptr;
        left = hn::Or(left, store_hits(d, scene, cells, line, from, walk, found, first, count, hits));
      }
    }
    // HitArrays::entry is 1, exit 2.
    const unsigned found_bits = lane_bits(d, found);
    const std::uint64_t states = bytes_of(found_bits) + bytes_of(found_bits & ~lane_bits(d, walk.inside()));
    std::memcpy(hits.faces.state + first, &states, count);
    if (wanted == Wanted::first && hits.faces.is_inside != nullptr)
      store_bytes(lane_bits(d, walk.started_inside()), hits.faces.is_inside + first, count);
    leave(*hits.left, first, lane_bits(d, left), counts);
  }
}

/// Appends the ends that a packet met to the existing intervals, ray by ray. `told` are the lanes to do so for.
template <class D>
HWY_INLINE void append_lists(D d, const RayPointers& rays, std::size_t first, std::size_t count,
                             const Walk<D, Wanted::all>& walk, const EndLog<D>& log, unsigned told,
                             const LaneLists& lists) {
  static_assert(sizeof(Interval) == 2 * sizeof(Crossing));
  const BitsOf<D> bits;
  HWY_ALIGN std::uint64_t met[16];
  hn::Store(walk.end_count(), bits, met);
  const unsigned start_inside = lane_bits(d, walk.started_inside());
  const unsigned end_inside = lane_bits(d, walk.inside());
  // The place of each lane's next end, counted in ends.
  std::size_t next[8];
  std::size_t total = 2 * lists.intervals->size();
  for (std::size_t lane = 0; lane < count; ++lane) {
    next[lane] = total;
    if (((told >> lane) & 1) != 0) total += met[lane] + ((start_inside >> lane) & 1) + ((end_inside >> lane) & 1);
    lists.ends[first + lane] = total / 2;
  }
  lists.intervals->resize(total / 2);
  auto* ends = reinterpret_cast<unsigned char*>(lists.intervals->data());
  if (lists.faces != nullptr) lists.faces->resize(total);
  EndFace* const faces = lists.faces != nullptr ? lists.faces->data() : nullptr;
  const auto put = [&](std::size_t lane, const Crossing& end, const auto& face_of) {
    if (faces != nullptr) faces[next[lane]] = face_of();
    std::memcpy(ends + sizeof(Crossing) * next[lane]++, &end, sizeof(Crossing));
  };
  const auto no_face = [] { return EndFace(); };
  for (unsigned rest = told & start_inside; rest != 0; rest &= rest - 1)
    put(static_cast<std::size_t>(__builtin_ctz(rest)), {rays.whole_line ? -HUGE_VAL : 0, {}, 0}, no_face);
  for (std::size_t row = 0; row < log.rows(); ++row) {
    for (unsigned rest = told & log.mask(row); rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(rest));
      put(lane, log.at(row, lane), [&] {
        EndFace face = log.face_at(row, lane);
        if (lists.wants_normals) face.normal = log.normal_at(row, lane);
        return face;
      });
    }
  }
  for (unsigned rest = told & end_inside; rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctz(rest));
    put(lane, {rays.end != nullptr ? rays.end[first + lane] : HUGE_VAL, {}, 1}, no_face);
  }
}

/// The same for one ray. Its ends are already in their place.
HWY_INLINE void append_lists(hn::Single<double>, const RayPointers& rays, std::size_t ray, std::size_t,
                             const Walk<hn::Single<double>, Wanted::all>& walk, EndLog<hn::Single<double>>& log,
                             unsigned told, const LaneLists& lists) {
  if (told == 0) log.clear();
  if (told != 0 && walk.inside()) log.add_end(rays.end != nullptr ? rays.end[ray] : HUGE_VAL);
  lists.ends[ray] = log.keep();
}

/// Memory for what rays meet.
template <class D>
HWY_INLINE EndLog<D> make_log(D, const RayPointers& rays, const LaneLists& lists) {
  if constexpr (hn::is_single<D>) {
    return EndLog<D>(lists, rays.whole_line ? -HUGE_VAL : 0);
  } else {
    return EndLog<D>();
  }
}

template <class D>
void cast_lists(const Scene& scene, const CellData& cells, const RayPointers& rays, const LaneLists& lists,
                PacketCounts& counts) {
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  LineLanes<D> line;
  line.wants_low = lists.rounds || lists.wants_normals;
  Departures<D> departures;
  EndLog<D> log = make_log(d, rays, lists);
  Walk<D, Wanted::all> walk(scene, cells, line, rays.departure != nullptr ? &departures : nullptr, &log, counts);
  walk.set_rounds(lists.rounds);
  walk.set_wants_normals(lists.wants_normals);
  for (std::size_t first = 0; first < rays.count; first += lanes) {
    const std::size_t count = HWY_MIN(lanes, rays.count - first);
    if (rays.departure != nullptr) set_departures(d, rays, first, count, departures);
    walk_packet(d, scene, cells, rays, first, count, line, walk, counts);
    const unsigned left = lane_bits(d, walk.flagged());
    const unsigned told = ((1u << count) - 1) & ~left;
    append_lists(d, rays, first, count, walk, log, told, lists);
    if (lists.rounds) add_lanes(*lists.unrounded, first, told & lane_bits(d, walk.unrounded()));
    leave(*lists.left, first, left, counts);
  }
}

template <class D>
LaneFunctions functions() {
  return {cast<D, Wanted::first>, cast<D, Wanted::any>, cast_lists<D>};
}

LaneCode lane_code(std::string_view name) {
  return {name, functions<hn::CappedTag<double, 8>>(), functions<hn::Single<double>>()};
}

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace csgcast::detail {

std::span<const LaneCode> lane_codes() {
  static const std::vector<LaneCode> codes = [] {
    std::vector<LaneCode> found;
#if HWY_TARGETS & HWY_AVX3
    if (has(InstructionSet::avx512)) found.push_back(N_AVX3::lane_code("AVX-512"));
#endif
#if HWY_TARGETS & HWY_AVX2
    if (has(InstructionSet::avx2)) found.push_back(N_AVX2::lane_code("AVX2"));
#endif
#if HWY_TARGETS & HWY_SSE4
    if (has(InstructionSet::sse4)) found.push_back(N_SSE4::lane_code("SSE4"));
#endif
    found.push_back(HWY_STATIC_DISPATCH(lane_code)("baseline"));
    return found;
  }();
  return codes;
}

}  // namespace csgcast::detail
#endif
