// SPDX-License-Identifier: MIT
// The states of a cell's surfaces along rays, and the cell's value in these states. Compiled once for each instruction
// set, by lanes.cpp.
#if defined(CSGCAST_LANE_VALUES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_VALUES_INL_H
#undef CSGCAST_LANE_VALUES_INL_H
#else
#define CSGCAST_LANE_VALUES_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "raycast/cells/build/cell_data.h"
#include "raycast/packets/detail/lane_events-inl.h"
#include "raycast/packets/detail/lane_line-inl.h"
#include "raycast/packets/detail/lane_order-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

/// The value of a state, by the cell's steps.
template <class D>
hn::Mask<BitsOf<D>> value_by_steps(D, const CellData& cells, const Cell& cell, hn::Vec<BitsOf<D>> state) {
  using Bits = BitsOf<D>;
  using U = hn::Vec<Bits>;
  const Bits bits;
  hn::Mask<Bits> stack[Cell::most_operands];
  std::size_t height = 0;
  for (std::size_t i = 0; i < cell.step_count; ++i) {
    const Step& step = cells.steps[cell.first_step + i];
    if (step.op == Step::Op::leaf) {
      const U off = hn::And(hn::Xor(state, hn::Set(bits, step.want)), hn::Set(bits, step.mask));
      stack[height++] = hn::Eq(off, hn::Zero(bits));
      continue;
    }
    if (step.op == Step::Op::complement) {
      stack[height - 1] = hn::Not(stack[height - 1]);
      continue;
    }
    --height;
    hn::Mask<Bits>& left = stack[height - 1];
    const hn::Mask<Bits> right = stack[height];
    left = step.op == Step::Op::unite       ? hn::Or(left, right)
           : step.op == Step::Op::intersect ? hn::And(left, right)
                                            : hn::AndNot(right, left);
  }
  return stack[0];
}

/// The value of a state, by the cell's table.
template <class D>
HWY_INLINE hn::Mask<D> value_by_table(D d, const Cell& cell, hn::Vec<BitsOf<D>> state) {
  const BitsOf<D> bits;
  const auto word = hn::Shr(hn::Set(bits, cell.table), state);
  return hn::RebindMask(d, hn::Ne(hn::And(word, hn::Set(bits, 1)), hn::Zero(bits)));
}

/// From this number of events on, lanes are faster.
constexpr std::size_t fewest_in_lanes = 9;

/// Returns one bit for each of the events [from, count) that is at most `at`.
HWY_NOINLINE std::uint64_t passed_events(const double* events, std::size_t from, std::size_t count, double at) {
  const SlotLanes d;
  const auto place = hn::hh::Set(d, at);
  std::uint64_t passed = 0;
  for (std::size_t i = 0; i < count; i += hn::hh::Lanes(d)) {
    passed |= std::uint64_t{lane_bits(d, hn::hh::Le(hn::hh::LoadU(d, events + i), place))} << i;
  }
  return passed & ((std::uint64_t{1} << count) - (std::uint64_t{1} << from));
}

/// The first of the events [from, count) after a place, or infinity if there is none.
HWY_NOINLINE double first_event_after(const double* events, std::size_t from, std::size_t count, double at) {
  const SlotLanes d;
  const auto place = hn::hh::Set(d, at);
  const auto never = hn::hh::Inf(d);
  auto next = never;
  for (std::size_t i = from; i < count; i += hn::hh::Lanes(d)) {
    const auto event = hn::hh::LoadU(d, events + i);
    const auto is_later = hn::hh::And(hn::hh::FirstN(d, count - i), hn::hh::Gt(event, place));
    next = hn::hh::Min(next, hn::hh::IfThenElse(is_later, event, never));
  }
  return hn::hh::GetLane(hn::hh::MinOfLanes(d, next));
}

/// The surfaces that are positive after the events up to a place. `may_be_many` says that the cell may have many
/// surfaces.
template <bool may_be_many, class D>
HWY_INLINE hn::Vec<BitsOf<D>> event_state(D, const Events<D>& events, const Cell& cell, hn::Vec<D> at) {
  if constexpr (may_be_many && hn::is_single<D>) {
    if (cell.slot_count >= fewest_in_lanes)
      return events.before ^ passed_events(events.first, 0, cell.slot_count, at) ^
             passed_events(events.second, cell.plane_count, cell.slot_count, at);
  }
  const BitsOf<D> bits;
  auto state = events.before;
  auto bit = hn::Set(bits, 1);
  const auto pass = [&](hn::Vec<D> event) {
    state = hn::Xor(state, hn::IfThenElseZero(hn::RebindMask(bits, hn::Le(event, at)), bit));
  };
  std::size_t i = 0;
  for (; i < cell.plane_count; ++i, bit = hn::Add(bit, bit)) pass(events.first[i]);
  for (; i < cell.slot_count; ++i, bit = hn::Add(bit, bit)) {
    pass(events.first[i]);
    pass(events.second[i]);
  }
  return state;
}

/// The same, and the first event after the place, or infinity if there is none. It takes one comparison for each event.
template <bool may_be_many, class D>
HWY_INLINE void pass_events(D d, const Events<D>& events, const Cell& cell, hn::Vec<D> at, hn::Vec<BitsOf<D>>& state,
                            hn::Vec<D>& next) {
  using V = hn::Vec<D>;
  if constexpr (may_be_many && hn::is_single<D>) {
    if (cell.slot_count >= fewest_in_lanes) {
      state = event_state<may_be_many>(d, events, cell, at);
      next = std::min(first_event_after(events.first, 0, cell.slot_count, at),
                      first_event_after(events.second, cell.plane_count, cell.slot_count, at));
      return;
    }
  }
  const BitsOf<D> bits;
  const V never = hn::Inf(d);
  auto passed = events.before;
  V first = never;
  auto bit = hn::Set(bits, 1);
  const auto pass = [&](V event) {
    const auto is_passed = hn::Le(event, at);
    passed = hn::Xor(passed, hn::IfThenElseZero(hn::RebindMask(bits, is_passed), bit));
    first = hn::Min(first, hn::IfThenElse(is_passed, never, event));
  };
  std::size_t i = 0;
  for (; i < cell.plane_count; ++i, bit = hn::Add(bit, bit)) pass(events.first[i]);
  for (; i < cell.slot_count; ++i, bit = hn::Add(bit, bit)) {
    pass(events.first[i]);
    pass(events.second[i]);
  }
  state = passed;
  next = first;
}

/// The lanes that meet a surface twice within slack, in the cell or next to it. Such a pair cannot be seen from the
/// states before and after it.
template <class D>
HWY_INLINE hn::Mask<D> twins(D d, const Events<D>& events, const Cell& cell, hn::Vec<D> from, hn::Vec<D> to) {
  using V = hn::Vec<D>;
  const V twice = hn::Add(events.slack, events.slack);
  const auto gap = [&](std::size_t i) { return hn::Sub(events.second[i], events.first[i]); };
  auto close = hn::MaskFromVec(hn::Zero(d));
  for (std::size_t i = cell.plane_count; i < cell.slot_count; ++i) close = hn::Or(close, hn::Le(gap(i), twice));
  if (hn::AllFalse(d, close)) return close;
  auto met = hn::MaskFromVec(hn::Zero(d));
  for (std::size_t i = cell.plane_count; i < cell.slot_count; ++i) {
    const auto is_here =
        hn::And(hn::Le(events.first[i], hn::Add(to, twice)), hn::Ge(events.second[i], hn::Sub(from, twice)));
    met = hn::Or(met, hn::And(is_here, hn::Le(gap(i), twice)));
  }
  return met;
}

/// The effect of two surfaces that flip close to each other.
template <class D>
struct Order {
  hn::Mask<D> does_not_matter;
  hn::Mask<D> by_first, by_second;  ///< the value changes, and this one alone decides it, before the other and after it
};

/// Computes it from four values: before both, after both, and after each of the two alone.
template <class D>
HWY_INLINE Order<D> order_of_two(D, hn::Mask<D> before, hn::Mask<D> after, hn::Mask<D> first, hn::Mask<D> second) {
  const auto first_changes = hn::Xor(before, first);
  const auto second_changes = hn::Xor(before, second);
  const auto changes = hn::Xor(before, after);
  const auto none = hn::AndNot(changes, hn::Not(hn::Or(first_changes, second_changes)));
  const auto by_first = hn::And(changes, hn::AndNot(second_changes, first_changes));
  const auto by_second = hn::And(changes, hn::AndNot(first_changes, second_changes));
  return {hn::Or(none, hn::Or(by_first, by_second)), by_first, by_second};
}

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
