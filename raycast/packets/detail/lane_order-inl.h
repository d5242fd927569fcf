// SPDX-License-Identifier: MIT
// Puts the events of one line in order. They are found side by side and sorted without branches. Compiled once for each
// instruction set, by lanes.cpp.
#if defined(CSGCAST_LANE_ORDER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_ORDER_INL_H
#undef CSGCAST_LANE_ORDER_INL_H
#else
#define CSGCAST_LANE_ORDER_INL_H
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstddef>
#include <cstdint>

#include "raycast/packets/detail/compress_table.h"
#include "raycast/packets/detail/lane_line-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {
namespace hh = hn::hh;

/// For single rays the lanes hold surfaces, not rays.
using SlotLanes = hh::CappedTag<double, 4>;

/// Appends the chosen lanes to a list, which must have room for all lanes. This takes two steps: numbers that are
/// compressed directly into memory cannot be read back for some time.
template <class D>
HWY_INLINE void put(D d, hh::Vec<D> values, hh::Mask<D> chosen, std::uint32_t* list, std::size_t& count) {
#if HWY_TARGET <= HWY_AVX3
  hh::StoreU(hh::Compress(values, chosen), d, list + count);
  count += hh::CountTrue(d, chosen);
#else
  // Highway's own function makes its table anew in each call, by hundreds of instructions.
  const unsigned lanes = lane_bits(d, chosen);
  const hh::Rebind<std::uint8_t, D> bytes;
  const auto order = hh::PromoteTo(d, hh::LoadU(bytes, compress_table[lanes].data()));
  hh::StoreU(hh::TableLookupLanes(values, hh::IndicesFromVec(d, order)), d, list + count);
  count += static_cast<std::size_t>(std::popcount(lanes));
#endif
}

/// Moves the chosen lanes to the front, in order.
template <class D>
HWY_INLINE hh::Vec<D> compressed(D d, hh::Vec<D> values, hh::Mask<D> chosen) {
#if HWY_TARGET <= HWY_AVX3
  (void)d;
  return hh::Compress(values, chosen);
#elif HWY_TARGET == HWY_SCALAR
  (void)d;
  (void)chosen;
  return values;
#else
  static_assert(sizeof(hh::TFromD<D>) == 8 && hh::MaxLanes(D()) <= 4);
  constexpr std::uint8_t halves[16] = {0x00, 0x03, 0x0c, 0x0f, 0x30, 0x33, 0x3c, 0x3f,
                                       0xc0, 0xc3, 0xcc, 0xcf, 0xf0, 0xf3, 0xfc, 0xff};
  const hh::Repartition<std::uint32_t, D> words;
  const hh::Rebind<std::uint8_t, decltype(words)> bytes;
  const std::uint8_t* const from = compress_table[halves[lane_bits(d, chosen)]].data();
  const auto order = hh::IndicesFromVec(words, hh::PromoteTo(words, hh::LoadU(bytes, from)));
  return hh::BitCast(d, hh::TableLookupLanes(hh::BitCast(words, values), order));
#endif
}

/// The crossings of one line with surfaces, in any order.
struct LineEvents {
  static constexpr std::size_t most = 2 * Cell::most_slots;

  double at[most + 16];
  std::uint64_t slot[most + 16];  ///< the slots of the events' surfaces
  std::size_t count;

  /// Adds the events of the chosen lanes.
  HWY_INLINE void add(SlotLanes d, hh::Vec<SlotLanes> events, hh::Vec<BitsOf<SlotLanes>> slots,
                      hh::Mask<SlotLanes> chosen) {
    const BitsOf<SlotLanes> bits;
    hh::StoreU(compressed(d, events, chosen), d, at + count);
    hh::StoreU(compressed(bits, slots, hh::RebindMask(bits, chosen)), bits, slot + count);
    count += hh::CountTrue(d, chosen);
  }

  HWY_INLINE void add(double event, std::uint64_t of, bool is_chosen) {
    at[count] = event;
    slot[count] = of;
    count += is_chosen;
  }
};

/// The same events in order. If several events share a place, the other places hold no number.
struct SortedEvents {
  double at[LineEvents::most + 16];
  std::uint64_t slot[LineEvents::most + 16];

  /// Sorts. An event's place is the number of events before it.
  HWY_INLINE void sort(LineEvents& events) {
    const SlotLanes d;
    constexpr std::size_t few = 2 * hh::MaxLanes(SlotLanes());
    const auto never = hh::Inf(d);
    hh::StoreU(never, d, events.at + events.count);
    hh::StoreU(never, d, events.at + events.count + hh::Lanes(d));
    if (events.count > few) return sort_many(events);
    for (std::size_t i = 0; i < few; i += hh::Lanes(d)) hh::StoreU(hh::NaN(d), d, at + i);
    const auto low = hh::LoadU(d, events.at), high = hh::LoadU(d, events.at + hh::Lanes(d));
    for (std::size_t i = 0; i < events.count; ++i) {
      const auto event = hh::Set(d, events.at[i]);
      const unsigned earlier = lane_bits(d, hh::Lt(low, event)) | lane_bits(d, hh::Lt(high, event)) << 8;
      set(static_cast<std::size_t>(std::popcount(earlier)), events, i);
    }
  }

 private:
  HWY_INLINE void set(std::size_t place, const LineEvents& events, std::size_t i) {
    at[place] = events.at[i];
    slot[place] = events.slot[i];
  }

  HWY_NOINLINE void sort_many(const LineEvents& events) {
    const SlotLanes d;
    const std::size_t lanes = hh::Lanes(d);
    for (std::size_t i = 0; i < events.count; i += lanes) hh::StoreU(hh::NaN(d), d, at + i);
    for (std::size_t i = 0; i < events.count; ++i) {
      const auto event = hh::Set(d, events.at[i]);
      std::size_t place = 0;
      for (std::size_t j = 0; j < events.count; j += lanes)
        place += static_cast<std::size_t>(std::popcount(lane_bits(d, hh::Lt(hh::LoadU(d, events.at + j), event))));
      set(place, events, i);
    }
  }
};

/// An event at which the tree's value changes.
struct LineEnd {
  std::uint64_t slot;
  std::uint64_t state;  ///< the state after the event

  HWY_INLINE bool rises() const { return ((state >> slot) & 1) != 0; }
};

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
