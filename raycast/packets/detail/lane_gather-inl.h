// SPDX-License-Identifier: MIT
// Lines gather from a hierarchy of boxes the surfaces of the few conjunctions that they may meet, and the tree's value
// over these surfaces. Compiled once for each instruction set, by lanes.cpp.
#if defined(CSGCAST_LANE_GATHER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_GATHER_INL_H
#undef CSGCAST_LANE_GATHER_INL_H
#else
#define CSGCAST_LANE_GATHER_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "raycast/cells/build/cell_data.h"
#include "raycast/packets/detail/lane_balls-inl.h"
#include "raycast/packets/detail/lane_boxes-inl.h"
#include "raycast/packets/detail/lane_cell-inl.h"
#include "raycast/packets/detail/lane_events-inl.h"
#include "raycast/packets/detail/lane_line-inl.h"
#include "raycast/packets/detail/lane_order-inl.h"
#include "raycast/packets/packet_counts.h"
#include "raycast/scene/scene.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

/// The surfaces of one cell, and the tree's value over them.
struct Gathered {
  struct Part {
    std::uint64_t mask, want;
    bool is_subtracted;
  };

  std::uint32_t slots[Cell::most_slots + 8];  ///< the slots of the surfaces; loads of whole registers reach beyond
  /// Conjunctions of a single surface that no other conjunction has. A ray is inside where the state differs from
  /// `flipped`.
  std::uint64_t united, subtracted, flipped;
  Part parts[Cell::most_slots];  ///< all other conjunctions
  std::size_t part_count;
  // These are used for a single ray that departs from nothing:
  std::uint64_t line_state;  ///< the state at the start of the stretch
  LineEvents line_events;    ///< the events on the stretch

  HWY_INLINE void begin() {
    united = subtracted = flipped = 0;
    part_count = 0;
    line_events.count = 0;
    line_state = 0;
  }
  /// Finds a slot among the first `count` slots. Returns its place, or `count` if it is not there.
  HWY_INLINE std::size_t place_of(std::uint32_t slot, std::size_t count) const {
    std::size_t at = 0;
    while (at < count && slots[at] != slot) ++at;
    return at;
  }
};

template <class D>
HWY_INLINE hn::Mask<BitsOf<D>> gathered_value(D, const Gathered& gathered, hn::Vec<BitsOf<D>> state) {
  const BitsOf<D> bits;
  const auto zero = hn::Zero(bits);
  const auto inside = hn::Xor(state, hn::Set(bits, gathered.flipped));
  auto in = hn::Ne(hn::And(inside, hn::Set(bits, gathered.united)), zero);
  auto out = hn::Ne(hn::And(inside, hn::Set(bits, gathered.subtracted)), zero);
  for (std::size_t i = 0; i < gathered.part_count; ++i) {
    const Gathered::Part& part = gathered.parts[i];
    const auto off = hn::And(hn::Xor(state, hn::Set(bits, part.want)), hn::Set(bits, part.mask));
    const auto holds = hn::Eq(off, zero);
    if (part.is_subtracted) {
      out = hn::Or(out, holds);
    } else {
      in = hn::Or(in, holds);
    }
  }
  return hn::AndNot(out, in);
}

/// Finds the conjunctions that the lines of some lanes may meet, and the events of their surfaces.
template <class D>
class Gatherer {
 public:
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  using Bits = BitsOf<D>;
  using U = hn::Vec<Bits>;

  Gatherer(const Scene& scene, const CellData& cells, const LineLanes<D>& line, const Departures<D>* departures,
           Events<D>& events, Gathered& gathered, PacketCounts& counts)
      : scene_(scene),
        cells_(cells),
        line_(line),
        departures_(departures),
        events_(events),
        gathered_(gathered),
        counts_(counts) {}

  /// Gathers between two places, for lanes whose directions have the same signs. Returns the number of surfaces, or
  /// nothing if there are too many.
  HWY_INLINE std::optional<std::size_t> gather(V from, V to, M lanes, unsigned signs) {
    signs_ = signs;
    Beam beam;
    set_beam(D(), line_, lanes, signs, from, to, beam);
    const bool are_few = find_conjunctions<hn::is_single<D>>(cells_.boxes, beam, met_);
    counts_.nodes += met_.node_count;
    if (!are_few) return std::nullopt;
    return gather_events(from, to, lanes);
  }

 private:
  /// Computes the events of the surfaces of all gathered conjunctions, except of those that the lanes miss. Returns the
  /// number of surfaces, or nothing if there are too many.
  HWY_INLINE std::optional<std::size_t> gather_events(V from, V to, M lanes) {
    const D d;
    const BoxTree& tree = cells_.boxes;
    clear_events(d, line_, tree.tolerance.slack, events_);
    gathered_.begin();
    const V margin = hn::Set(d, 4 * greatest_slack);
    const Stretch stretch{hn::Sub(from, margin), hn::Add(to, margin), lanes};
    std::size_t count = 0;
    if constexpr (hn::is_single<D>) {
      if (departures_ == nullptr) count = add_balls(stretch);
    }
    const std::size_t ball_count = count;
    const bool knows_bricks = departures_ == nullptr && !line_.any_is_loose;
    for (std::size_t k = 0; k < met_.conjunction_count; ++k) {
      const std::uint32_t id = met_.conjunctions[k];
      if ((id & BoxNode::ball) == BoxNode::ball) {
        if (count == Cell::most_slots) return std::nullopt;
        const std::uint32_t slot = id & (BoxNode::most_slots - 1);
        count =
            add_simple({slot, cells_.slots[slot].c[5] <= 0, false}, (id & BoxNode::subtracted) != 0, stretch, count);
        continue;
      }
      const Conjunction& conjunction = tree.conjunctions[id - BoxNode::conjunction];
      if (count + conjunction.count > Cell::most_slots) return std::nullopt;
      const BoxedSide& side = tree.sides[conjunction.first];
      if constexpr (hn::is_single<D>) {
        const bool is_brick = knows_bricks && conjunction.brick != Conjunction::no_brick;
        if (is_brick && add_brick(tree.bricks[conjunction.brick], conjunction.is_subtracted, stretch, count)) continue;
      }
      if (conjunction.count == 1 && !side.is_shared) {
        count = add_simple(side, conjunction.is_subtracted, stretch, count);
      } else {
        count = add_conjunction(tree, conjunction, stretch, count);
      }
    }
    if constexpr (hn::is_single<D>) {
      if (departures_ == nullptr) add_line_events(stretch, ball_count, count);
    }
    return count;
  }

  /// The part of the lines that is examined.
  struct Stretch {
    V from, to;
    M lanes;
  };

  /// The state of a surface along the stretch.
  struct Course {
    M meets;     ///< lanes that cross the surface on the stretch
    M positive;  ///< lanes in which the surface is positive at the start of the stretch
  };

  /// Computes a surface's events and stores them at a place.
  HWY_INLINE Course course_of(const Slot& slot, const Stretch& stretch, std::size_t at) {
    const D d;
    const Bits bits;
    ++counts_.surface_tests;
    add_events(d, scene_, line_, cells_.axis_bounds, slot, departures_, at, events_);
    if (is_plane(slot.kind)) events_.second[at] = hn::Inf(d);
    const V first = events_.first[at];
    const V second = events_.second[at];
    const auto within = [&](V event) { return hn::And(hn::Ge(event, stretch.from), hn::Le(event, stretch.to)); };
    const U bit = hn::Set(bits, std::uint64_t{1} << at);
    const M before = hn::RebindMask(d, hn::Ne(hn::And(events_.before, bit), hn::Zero(bits)));
    return {hn::Or(within(first), within(second)),
            hn::Xor(before, hn::Xor(hn::Lt(first, stretch.from), hn::Lt(second, stretch.from)))};
  }

  /// Forgets the events in places [from, to).
  HWY_INLINE void forget_events(std::size_t from, std::size_t to) {
    const std::uint64_t kept = ~((std::uint64_t{1} << to) - (std::uint64_t{1} << from));
    events_.before = hn::And(events_.before, hn::Set(Bits(), kept));
  }

  /// Adds the spheres that a single ray may meet as the first slots, some of which stay empty. Returns the number of
  /// these slots.
  HWY_INLINE std::size_t add_balls(const Stretch& stretch) {
    const SlotLanes d;
    const BitsOf<SlotLanes> bits;
    const hh::Rebind<std::uint32_t, SlotLanes> ids;
    const std::size_t lanes = hh::Lanes(d);
    std::uint32_t balls[Cell::most_slots + 24];
    balls[0] = BoxNode::ball;
    const std::size_t count = met_.take_balls(balls);
    counts_.surface_tests += count;
    const BallLine line(line_);
    const auto from = hh::Set(d, stretch.from);
    const auto to = hh::Set(d, stretch.to);
    const auto never = hh::Inf(d);
    auto open = hh::MaskFromVec(hh::Zero(d));
    for (std::size_t k = 0; k < count; k += lanes) {
      const Slot* slots[8];
      for (std::size_t i = 0; i < lanes; ++i) slots[i] = &cells_.slots[balls[k + i] & (BoxNode::most_slots - 1)];
      const BallRow row = ball_row(line, slots);
      const auto is_there = hh::FirstN(d, count - k);
      open = hh::Or(open, hh::And(is_there, row.is_open));
      const auto begins = hh::Ge(row.first, from);
      const auto has_first = hh::And(is_there, hh::And(begins, hh::Le(row.first, to)));
      const auto has_second = hh::And(is_there, hh::And(hh::Ge(row.second, from), hh::Le(row.second, to)));
      const auto starts_in = hh::AndNot(begins, hh::And(is_there, hh::Ge(row.second, from)));
      const auto matters = hh::Or(has_first, hh::Or(has_second, starts_in));
      const auto slot = hh::Add(hh::Iota(bits, 0), hh::Set(bits, k));
      gathered_.line_events.add(d, row.first, slot, has_first);
      gathered_.line_events.add(d, row.second, slot, has_second);
      hh::StoreU(hh::IfThenElse(matters, row.first, never), d, events_.first + k);
      hh::StoreU(hh::IfThenElse(matters, row.second, never), d, events_.second + k);
      const auto found = hh::LoadU(ids, balls + k);
      hh::StoreU(hh::And(found, hh::Set(ids, BoxNode::most_slots - 1)), ids, gathered_.slots + k);
      const auto subtracted = hh::Set(ids, BoxNode::subtracted);
      const std::uint64_t out = lane_bits(ids, hh::Eq(hh::And(found, subtracted), subtracted));
      const std::uint64_t kept = lane_bits(d, matters);
      const std::uint64_t positive = kept & lane_bits(d, row.outside_is_positive);
      events_.before |= positive << k;
      gathered_.line_state |= (positive ^ (kept & lane_bits(d, starts_in))) << k;
      gathered_.flipped |= positive << k;
      gathered_.united |= (kept & ~out) << k;
      gathered_.subtracted |= (kept & out) << k;
    }
    flag(events_, !hh::AllFalse(d, open));
    return count;
  }

  /// Adds the planes by which a single ray enters and leaves a brick on the stretch, if it does. If other planes of the
  /// brick are too close to these events, nothing is done and false is returned.
  HWY_INLINE bool add_brick(const Brick& brick, bool is_subtracted, const Stretch& stretch, std::size_t& count) {
    const double apart = 2 * line_.slack;
    const BrickCrossings at = brick_crossings(line_, brick, apart);
    if (at.enters > at.leaves + apart || at.enters > stretch.to || at.leaves < stretch.from) return true;
    if (!std::has_single_bit(at.enters_by) || !std::has_single_bit(at.leaves_by) || at.leaves <= at.enters + apart)
      return false;
    Gathered::Part part{0, 0, is_subtracted};
    const auto add = [&](double event, unsigned by, bool is_entry) {
      if (event < stretch.from || event > stretch.to) return;
      const bool is_lower = ((signs_ & by) == 0) == is_entry;
      const std::uint32_t slot = (is_lower ? brick.lower_slot : brick.upper_slot)[std::countr_zero(by)];
      const bool wants_positive = is_lower == (cells_.slots[slot].c[1] > 0);
      const std::uint64_t bit = std::uint64_t{1} << count;
      events_.first[count] = event;
      events_.second[count] = hn::Inf(D());
      part.mask |= bit;
      if (wants_positive) part.want |= bit;
      if (wants_positive != is_entry) events_.before |= bit;
      gathered_.slots[count++] = slot;
    };
    add(at.enters, at.enters_by, true);
    add(at.leaves, at.leaves_by, false);
    counts_.surface_tests += 6;
    gathered_.parts[gathered_.part_count++] = part;
    return true;
  }

  /// Adds the events of the slots [from, to) to those of the balls.
  HWY_INLINE void add_line_events(const Stretch& stretch, std::size_t from, std::size_t to) {
    const std::uint64_t balls = (std::uint64_t{1} << from) - 1;
    gathered_.line_state |= events_.before & ~balls;
    for (std::size_t i = from; i < to; ++i) {
      for (const double event : {events_.first[i], events_.second[i]}) {
        gathered_.line_state ^= std::uint64_t{event < stretch.from} << i;
        gathered_.line_events.add(event, i, (event >= stretch.from) & (event <= stretch.to));
      }
    }
  }

  /// Adds a conjunction of a single surface that no other conjunction has. Returns the new number of slots.
  HWY_INLINE std::size_t add_simple(const BoxedSide& side, bool is_subtracted, const Stretch& stretch,
                                    std::size_t count) {
    const Course course = course_of(cells_.slots[side.slot], stretch, count);
    const M holds = side.wants_positive ? course.positive : hn::Not(course.positive);
    // It is unpredictable whether some lane meets it, so packets use no branch here.
    const bool matters = !hn::AllFalse(D(), hn::And(stretch.lanes, hn::Or(course.meets, holds)));
    if (hn::is_single<D> && !matters) {
      forget_events(count, count + 1);
      return count;
    }
    const std::uint64_t bit = std::uint64_t{matters} << count;
    forget_events(count + matters, count + 1);
    gathered_.slots[count] = side.slot;
    gathered_.united |= is_subtracted ? 0 : bit;
    gathered_.subtracted |= is_subtracted ? bit : 0;
    gathered_.flipped |= side.wants_positive ? 0 : bit;
    return count + matters;
  }

  /// Adds a conjunction of several surfaces. A surface matters if lanes cross it on the stretch. The whole conjunction
  /// is dropped if the lanes are on the wrong side of another surface all along.
  HWY_INLINE std::size_t add_conjunction(const BoxTree& tree, const Conjunction& conjunction, const Stretch& stretch,
                                         std::size_t count) {
    const D d;
    const std::size_t before = count;
    Gathered::Part part{0, 0, conjunction.is_subtracted};
    for (std::size_t i = 0; i < conjunction.count; ++i) {
      const BoxedSide& side = tree.sides[conjunction.first + i];
      const std::size_t at = side.is_shared ? gathered_.place_of(side.slot, count) : count;
      if (at == count) {
        const Course course = course_of(cells_.slots[side.slot], stretch, at);
        if (hn::AllFalse(d, hn::And(stretch.lanes, course.meets))) {
          const M holds = side.wants_positive ? course.positive : hn::Not(course.positive);
          if (hn::AllFalse(d, hn::And(stretch.lanes, holds))) {
            forget_events(before, at + 1);
            return before;
          }
          if (hn::AllFalse(d, hn::AndNot(holds, stretch.lanes))) {
            forget_events(at, at + 1);
            continue;
          }
        }
        gathered_.slots[count++] = side.slot;
      }
      const std::uint64_t bit = std::uint64_t{1} << at;
      part.mask |= bit;
      if (side.wants_positive) part.want |= bit;
    }
    gathered_.parts[gathered_.part_count++] = part;
    return count;
  }

  const Scene& scene_;
  const CellData& cells_;
  const LineLanes<D>& line_;
  const Departures<D>* departures_;
  Events<D>& events_;
  Gathered& gathered_;
  PacketCounts& counts_;
  unsigned signs_ = 0;  ///< the axes along which the lines fall, one bit each
  Met met_;
};

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
