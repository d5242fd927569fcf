// SPDX-License-Identifier: MIT
// Finds what rays meet in one cell, with a ray in each lane, from event to event. Compiled once for each instruction
// set, by lanes.cpp.
#if defined(CSGCAST_LANE_SWEEP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_SWEEP_INL_H
#undef CSGCAST_LANE_SWEEP_INL_H
#else
#define CSGCAST_LANE_SWEEP_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "raycast/cells/build/cell_data.h"
#include "raycast/packets/detail/lane_events-inl.h"
#include "raycast/packets/detail/lane_gather-inl.h"
#include "raycast/packets/detail/lane_hits-inl.h"
#include "raycast/packets/detail/lane_line-inl.h"
#include "raycast/packets/detail/lane_log-inl.h"
#include "raycast/packets/detail/lane_order-inl.h"
#include "raycast/packets/detail/lane_round-inl.h"
#include "raycast/packets/detail/lane_values-inl.h"
#include "raycast/scene/scene.h"
#include "raycast/surface/surface.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

enum class Wanted : std::uint8_t { first, any, all };

/// The results of a packet, cell by cell. A lane is live until its answer is known or it is left to the caster.
template <class D, Wanted wanted>
class Sweep {
 public:
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  using Bits = BitsOf<D>;
  using U = hn::Vec<Bits>;

  Sweep(const Scene& scene, const CellData& cells, const LineLanes<D>& line, const Departures<D>* departures,
        EndLog<D>* ends)
      : scene_(scene), cells_(cells), line_(line), departures_(departures), ends_(ends) {}

  /// Starts without any results.
  HWY_INLINE void begin() {
    const V zero = hn::Zero(D());
    flagged_ = found_ = begun_ = now_inside_ = started_inside_ = unrounded_ = hn::MaskFromVec(zero);
    if constexpr (wanted == Wanted::all) ends_->clear();
    slot_ = count_ = hn::Zero(Bits());
    rises_ = covered_lanes_ = found_;
    covered_ = zero;
  }
  /// If true, t of ends is rounded to the nearest double where lanes can do that.
  void set_rounds(bool rounds) { rounds_ = rounds; }
  /// If true, the normals of ends are computed.
  void set_wants_normals(bool wants) { wants_normals_ = wants; }

  M flagged() const { return flagged_; }
  M found() const { return found_; }        ///< the lanes that have an answer other than a miss
  M inside() const { return now_inside_; }  ///< of these, the lanes that are inside right after the hit
  M started_inside() const { return started_inside_; }
  U slot() const { return slot_; }
  M rises() const { return rises_; }  ///< lanes in which the surface turns positive
  U end_count() const { return count_; }
  M unrounded() const { return unrounded_; }  ///< lanes with an end whose t lanes could not round

 protected:
  static constexpr bool uses_boxes = wanted == Wanted::all;
  static constexpr std::uint16_t gathered_cell = 0xffff;  // the number of steps that marks the gathered cell

  HWY_INLINE std::uint32_t slot_of(const Cell& cell, std::size_t i) const {
    return is_gathered(cell) ? gathered_.slots[i] : cell.first_slot + static_cast<std::uint32_t>(i);
  }

  HWY_INLINE U state_at(const Cell& cell, V at) const { return event_state<uses_boxes>(D(), events_, cell, at); }
  HWY_INLINE M value_of(const Cell& cell, U state) const {
    return cell.step_count == 0 ? value_by_table(D(), cell, state) : value_of_large(cell, state);
  }
  HWY_NOINLINE M value_of_large(const Cell& cell, U state) const {
    const auto value =
        is_gathered(cell) ? gathered_value(D(), gathered_, state) : value_by_steps(D(), cells_, cell, state);
    return hn::RebindMask(D(), value);
  }
  static HWY_INLINE bool is_gathered(const Cell& cell) { return uses_boxes && cell.step_count == gathered_cell; }

  HWY_INLINE void flag(M lanes) {
    if constexpr (!certified) return;
    if (hn::AllFalse(D(), lanes)) return;
    flagged_ = hn::Or(flagged_, lanes);
    live_ = hn::AndNot(lanes, live_);
  }

  /// Tells lanes that start in the cell if they start inside.
  HWY_INLINE void begin_in(M lanes, M inside) {
    now_inside_ = hn::Or(hn::AndNot(lanes, now_inside_), hn::And(lanes, inside));
    started_inside_ = hn::Or(started_inside_, hn::And(lanes, inside));
    if constexpr (wanted == Wanted::any) {
      found_ = hn::Or(found_, hn::And(lanes, inside));
      live_ = hn::AndNot(hn::And(lanes, inside), live_);
    }
    if constexpr (wanted == Wanted::all && hn::is_single<D>) {
      if (lanes & inside) ends_->add_start();
    }
  }

  /// Finds what the lanes meet in a cell whose events are known.
  HWY_INLINE void look_into(const Cell& cell, V from, V to, M active, M starting) {
    const D d;
    crossings_.known = 0;
    M open = hn::Xor(active, active);
    if constexpr (certified) {
      open = hn::And(active, events_.flagged);
      const bool may_have_twins =
          departures_ == nullptr ? cell.tolerance.may_have_twins : cell.tolerance.departing_may_have_twins;
      if (may_have_twins) open = hn::Or(open, hn::And(active, twins(d, events_, cell, from, to)));
    }
    starting = hn::AndNot(open, hn::And(starting, live_));
    if (!hn::AllFalse(d, starting)) start(cell, starting);
    sweep(cell, from, to, hn::And(active, live_), open);
  }

  /// Finds the state in which lanes start. Lanes with an event at the start are flagged.
  void start(const Cell& cell, M lanes) {
    const D d;
    const U after = state_at(cell, hn::Add(line_.start, events_.slack));
    if constexpr (!certified) return begin_in(lanes, value_of(cell, after));
    const U before = state_at(cell, hn::Sub(line_.start, events_.slack));
    const M differs = hn::And(lanes, hn::RebindMask(d, hn::Ne(before, after)));
    flag(differs);
    begin_in(hn::AndNot(differs, lanes), value_of(cell, after));
  }

  /// Passes event by event, as long as some lane has one in the cell. An event is certain if no other is within slack
  /// of it. `open` are the lanes that are not certain of the cell's events.
  HWY_INLINE void sweep(const Cell& cell, V from, V to, M active, M open) {
    const D d;
    const V slack = events_.slack;
    V limit = hn::Add(to, slack);
    // The limit must be finite, because an infinite event is none.
    if (cells_.reaches_beyond) limit = hn::Min(limit, hn::Set(d, std::numeric_limits<double>::max()));
    // The last cell was examined up to its own slack beyond the border. This cell goes on from there.
    V at = hn::IfThenElse(covered_lanes_, covered_, hn::Add(from, slack));
    covered_ = hn::IfThenElse(active, hn::Max(limit, at), covered_);
    covered_lanes_ = hn::Or(covered_lanes_, active);
    if constexpr (hn::is_single<D> && wanted == Wanted::all) {
      flag(open);
      if (!active || open || sweep_few(cell, at, limit)) return;
    }
    U state;
    V next;
    pass_events<uses_boxes>(d, events_, cell, at, state, next);
    // These are the lanes with an event to look at. Close to the ray's end nothing is certain.
    const auto due = [&](M lanes) {
      const M todo = hn::And(lanes, hn::Le(next, limit));
      if (line_.ends) flag(hn::And(todo, hn::Gt(next, hn::Sub(line_.end, hn::Add(slack, line_.end_error)))));
      return hn::And(todo, live_);
    };
    M todo = due(active);
    if (hn::AllFalse(d, hn::Or(todo, open))) return;
    if constexpr (certified) open = hn::Or(open, hn::And(todo, hn::Xor(value_of(cell, state), now_inside_)));
    do {
      const V place = next;
      at = hn::Add(next, slack);
      U after;
      pass_events<uses_boxes>(d, events_, cell, at, after, next);
      U flips = hn::Xor(state, after);
      const M value = value_of(cell, after);
      M changes = hn::And(todo, hn::Xor(value, now_inside_));
      if constexpr (certified) {
        const M several = hn::And(has_several_bits(d, flips), todo);
        if (HWY_UNLIKELY(!hn::AllFalse(d, hn::Or(several, open)))) {
          flag(open);
          open = hn::Xor(open, open);
          settle(cell, state, after, place, hn::And(several, live_), flips);
          todo = hn::And(todo, live_);
          changes = hn::And(changes, live_);
        }
      }
      record(cell, changes, flips, after);
      state = after;
      now_inside_ = hn::Or(hn::AndNot(changes, now_inside_), hn::And(changes, value));
      todo = due(hn::And(todo, live_));
    } while (!hn::AllFalse(d, todo));
  }

  /// Does the same for a single ray with few events ahead that are at least two error bounds apart. Otherwise it does
  /// nothing and returns false.
  HWY_INLINE bool sweep_few(const Cell& cell, double at, double limit) {
    constexpr std::size_t few = 6;
    const double apart = 2 * events_.slack;
    const double beyond = limit + apart;
    double place[Cell::most_slots * 2];
    std::uint8_t slot[Cell::most_slots * 2];
    std::size_t count = 0;
    U state = events_.before;
    const auto pass = [&](double event, std::size_t i) {
      const bool is_ahead = event > at;
      state ^= std::uint64_t{!is_ahead} << i;
      place[count] = event;
      slot[count] = static_cast<std::uint8_t>(i);
      count += is_ahead & (event <= beyond);
    };
    for (std::size_t i = 0; i < cell.slot_count; ++i) pass(events_.first[i], i);
    for (std::size_t i = cell.plane_count; i < cell.slot_count; ++i) pass(events_.second[i], i);
    if (count > few) return false;
    for (std::size_t i = 1; i < count; ++i) {
      for (std::size_t k = i; k > 0 && place[k] < place[k - 1]; --k) {
        std::swap(place[k], place[k - 1]);
        std::swap(slot[k], slot[k - 1]);
      }
    }
    const double last = line_.ends ? line_.end - (events_.slack + line_.end_error) : limit;
    bool are_apart = true;
    for (std::size_t i = 1; i < count; ++i) are_apart &= place[i] - place[i - 1] > apart;
    std::size_t due = 0;
    while (due < count && place[due] <= limit) ++due;
    if (due == 0) return true;
    if (!are_apart || place[due - 1] > last) return false;
    if (certified && value_of(cell, state) != now_inside_) return false;
    for (std::size_t i = 0; i < due && live_; ++i) {
      state ^= std::uint64_t{1} << slot[i];
      if (value_of(cell, state) != now_inside_) add_end(cell, {slot[i], state});
    }
    return true;
  }

  /// Does `sweep`, and `start` before it, for a single ray whose events are gathered and at least two error bounds
  /// apart. Otherwise it does nothing and returns false.
  HWY_INLINE bool sweep_in_order(const Cell& cell, double from, double to, bool starting) {
    LineEvents& events = gathered_.line_events;
    if (events_.flagged) return false;
    sorted_.sort(events);
    const double slack = events_.slack;
    const double apart = slack + slack;
    const double at = from + slack;
    const double limit = to + slack;
    const double last = line_.ends ? line_.end - (slack + line_.end_error) : limit;
    const double* const place = sorted_.at;
    double before = -hn::Inf(D());
    U state = gathered_.line_state;
    bool are_apart = true;
    std::size_t i = 0;
    const auto pass = [&] {
      are_apart &= place[i] - before > apart;
      before = place[i];
      state ^= std::uint64_t{1} << sorted_.slot[i++];
    };
    while (i < events.count && place[i] <= at) pass();
    const bool starts_inside = gathered_value(D(), gathered_, state);
    // If the ray starts near an event, or enters the stretch from beyond while inside, the other code handles it.
    if (starting ? before > from - slack : starts_inside) return false;
    bool inside = starts_inside;
    std::size_t end_count = 0;
    while (i < events.count && place[i] <= limit) {
      pass();
      const bool value = gathered_value(D(), gathered_, state);
      // It is unpredictable whether the event is an end.
      line_ends_[end_count] = {sorted_.slot[i - 1], state};
      end_count += value != inside;
      inside = value;
    }
    if (i > 0 && before > last) return false;
    if (i < events.count) are_apart &= place[i] - before > apart;
    if (!are_apart) return false;
    crossings_.known = 0;
    if (starting) begin_in(true, starts_inside);
    now_inside_ = starts_inside;
    for (std::size_t k = 0; k < end_count; ++k) add_end(cell, line_ends_[k]);
    return true;
  }

  /// Adds the next end of a single ray.
  HWY_INLINE void add_end(const Cell& cell, const LineEnd& end) {
    if (rounds_ || wants_normals_ || departures_ != nullptr) {
      append(cell, true, end.slot, end.rises(), !now_inside_);
    } else {
      append_plain(cell, end);
    }
    now_inside_ = !now_inside_;
  }

  /// Does `append` for a single ray that departs from nothing, in the most common case.
  HWY_INLINE void append_plain(const Cell& cell, const LineEnd& end) {
    const D d;
    const Slot& slot = cells_.slots[slot_of(cell, end.slot)];
    const Surface& surface = scene_.surfaces()[slot.surface];
    U root;
    M is_open;
    const V tau = crossings_.tau(d, line_, surface, end.slot, false, end.rises(), root, is_open);
    flag(is_open);
    ends_->add(true, (line_.shift + tau) * line_.unit, slot.surface | root << 32,
               slot.leaf | std::uint64_t{slot.look} << 32);
    ++count_;
  }

  /// Handles two surfaces that flip within slack of each other. Their order does not matter if the value is the same in
  /// between, or if one of them alone decides the value both before and after. All other cases are flagged. `flips`
  /// becomes the surface that decides.
  void settle(const Cell& cell, U state, U after, V next, M several, U& flips) {
    const D d;
    const Bits bits;
    const U low = hn::And(flips, hn::Sub(hn::Zero(bits), flips));
    const U high = hn::Xor(flips, low);
    const U later = state_at(cell, hn::Add(next, hn::Add(events_.slack, events_.slack)));
    const M is_pair = hn::AndNot(has_several_bits(d, high), hn::RebindMask(d, hn::Eq(later, after)));
    const Order<D> order = order_of_two(d, now_inside_, value_of(cell, after), value_of(cell, hn::Xor(state, low)),
                                        value_of(cell, hn::Xor(state, high)));
    const M settled = hn::And(is_pair, order.does_not_matter);
    flag(hn::AndNot(settled, several));
    const auto in_bits = [&](M lanes) { return hn::RebindMask(bits, hn::And(several, lanes)); };
    flips = hn::IfThenElse(in_bits(order.by_first), low, hn::IfThenElse(in_bits(order.by_second), high, flips));
  }

  HWY_INLINE void record(const Cell& cell, M changes, U flips, U after) {
    const Bits bits;
    if (hn::AllFalse(D(), changes)) return;
    const auto lanes = hn::RebindMask(bits, changes);
    const U index = logarithm(D(), flips);
    const M rises = hn::RebindMask(D(), hn::Ne(hn::And(flips, after), hn::Zero(bits)));
    if constexpr (wanted == Wanted::all) return append(cell, changes, index, rises, hn::Not(now_inside_));
    slot_ = hn::IfThenElse(lanes, hn::Add(hn::Set(bits, cell.first_slot), index), slot_);
    rises_ = hn::Or(rises_, hn::And(changes, rises));
    found_ = hn::Or(found_, changes);
    live_ = hn::AndNot(changes, live_);
  }

  void append(const Cell& cell, M changes, U index, M rises, M enters) {
    const D d;
    const Bits bits;
    HWY_ALIGN std::uint64_t indices[16];
    hn::Store(index, bits, indices);
    V t = hn::Zero(d);
    U where = hn::Zero(bits);
    U face = hn::Zero(bits);
    Triples<V> normals{t, t, t};
    for (M rest = changes; !hn::AllFalse(d, rest);) {
      const std::uint64_t i = indices[static_cast<std::size_t>(hn::FindFirstTrue(d, rest))];
      const M same = hn::And(rest, hn::RebindMask(d, hn::Eq(index, hn::Set(bits, i))));
      rest = hn::AndNot(same, rest);
      const Slot& slot = cells_.slots[slot_of(cell, i)];
      const std::uint32_t id = slot.surface;
      U root;
      M is_open;
      const Surface& surface = scene_.surfaces()[id];
      const M own_surface = own_lanes(d, departures_, id);
      const bool keeps = is_gathered(cell);  // both ends of what was gathered are probably wanted
      const V tau = keeps ? crossings_.tau(d, line_, surface, i, own_surface, rises, root, is_open)
                          : crossing_tau(d, line_, surface, own_surface, rises, root, is_open);
      flag(hn::And(same, is_open));
      V own = hn::Mul(hn::Add(line_.shift, tau), line_.unit);
      if (rounds_) {
        V nearest;
        const M certain = hn::AndNot(own_surface, nearest_t_lanes(d, line_, surface, tau, nearest));
        own = hn::IfThenElse(certain, nearest, own);
        unrounded_ = hn::Or(unrounded_, hn::AndNot(certain, same));
      }
      t = hn::IfThenElse(same, own, t);
      const auto in_bits = hn::RebindMask(bits, same);
      where = hn::IfThenElse(in_bits, hn::Or(hn::Set(bits, id), hn::ShiftLeft<32>(root)), where);
      face = hn::IfThenElse(in_bits, hn::Set(bits, slot.leaf | std::uint64_t{slot.look} << 32), face);
      if (!wants_normals_) continue;
      const Triples<V> place = place_of(d, line_, scene_.frame(), tau);
      normals = choose(same, unit_gradient(d, surface, scene_.frame(), place), normals);
    }
    ends_->add(changes, t, where, face);
    if (wants_normals_) {
      flag(hn::And(changes, hn::Eq(longest(normals), hn::Zero(d))));
      ends_->set_normals(choose(hn::Xor(enters, rises), normals, -normals));
    }
    count_ = hn::Add(count_, hn::IfThenElseZero(hn::RebindMask(bits, changes), hn::Set(bits, 1)));
  }

  const Scene& scene_;
  const CellData& cells_;
  const LineLanes<D>& line_;
  const Departures<D>* departures_;
  EndLog<D>* ends_;
  Events<D> events_;
  CellCrossings<D> crossings_;
  Gathered gathered_;
  // These are used for a single ray that gathers:
  SortedEvents sorted_;
  LineEnd line_ends_[LineEvents::most + 1];
  M live_, flagged_, found_, begun_, now_inside_, started_inside_, rises_, unrounded_, covered_lanes_;
  V covered_;
  bool rounds_ = false;
  bool wants_normals_ = false;
  U slot_, count_;
};

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
