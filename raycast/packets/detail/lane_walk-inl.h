// SPDX-License-Identifier: MIT
// Takes rays through the cells, with a ray in each lane, from front to back. Compiled once for each instruction set, by
// lanes.cpp.
#if defined(CSGCAST_LANE_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_WALK_INL_H
#undef CSGCAST_LANE_WALK_INL_H
#else
#define CSGCAST_LANE_WALK_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "raycast/cells/build/cell_data.h"
#include "raycast/packets/detail/lane_cell-inl.h"
#include "raycast/packets/detail/lane_events-inl.h"
#include "raycast/packets/detail/lane_gather-inl.h"
#include "raycast/packets/detail/lane_line-inl.h"
#include "raycast/packets/detail/lane_log-inl.h"
#include "raycast/packets/detail/lane_sweep-inl.h"
#include "raycast/packets/packet_counts.h"
#include "raycast/scene/scene.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

/// One packet's way through the cells.
template <class D, Wanted wanted>
class Walk : public Sweep<D, wanted> {
  using Base = Sweep<D, wanted>;

 public:
  using typename Base::M;
  using typename Base::V;

  Walk(const Scene& scene, const CellData& cells, const LineLanes<D>& line, const Departures<D>* departures,
       EndLog<D>* ends, PacketCounts& counts)
      : Base(scene, cells, line, departures, ends), counts_(counts) {}

  using Base::begin;
  /// `lanes` are the lanes that hold a ray.
  HWY_INLINE void run(M lanes) {
    const D d;
    begin();
    flagged_ = hn::AndNot(line_.valid, lanes);
    live_ = hn::And(lanes, line_.valid);
    V from = line_.start;
    V to = line_.end;
    if (cells_.is_empty) return;
    const M far_out = hn::Gt(longest(line_.near), hn::Set(d, 4.0));
    if (cells_.reaches_beyond) {
      flag(hn::And(live_, far_out));
    } else {
      live_ = hn::AndNot(far_out, live_);
      clip_to_box(d, line_, cells_.box, from, to);
    }
    M waiting = hn::And(live_, hn::Le(from, to));
    if constexpr (hn::is_single<D>) {
      if (waiting) go(from, to, waiting, falling_axes(d, line_, 0));
      return;
    }
    // Lanes whose directions have the same signs go together, because they share the order of the cells.
    while (!hn::AllFalse(d, waiting)) {
      const std::size_t leader = static_cast<std::size_t>(hn::FindFirstTrue(d, waiting));
      const unsigned signs = falling_axes(d, line_, leader);
      M group = waiting;
      for (unsigned axis = 0; axis < 3; ++axis) {
        const M negative = hn::Lt(line_.axis_inverse[axis], hn::Zero(d));
        group = ((signs >> axis) & 1) != 0 ? hn::And(group, negative) : hn::AndNot(negative, group);
      }
      waiting = hn::AndNot(group, waiting);
      go(from, to, group, signs);
    }
  }

 private:
  using Base::begin_in;
  using Base::begun_;
  using Base::cells_;
  using Base::covered_lanes_;
  using Base::departures_;
  using Base::events_;
  using Base::flag;
  using Base::flagged_;
  using Base::gathered_;
  using Base::gathered_cell;
  using Base::line_;
  using Base::live_;
  using Base::look_into;
  using Base::now_inside_;
  using Base::scene_;
  using Base::sweep_in_order;
  using Base::uses_boxes;

  /// Takes lanes whose directions have the same signs through the cells.
  HWY_INLINE void go(V from, V to, M lanes, unsigned signs) {
    if (uses_boxes && !cells_.boxes.nodes.empty() && go_by_boxes(from, to, lanes, signs)) return;
    descend(from, hn::IfThenElse(lanes, to, hn::Neg(hn::Inf(D()))), signs);
  }

  /// Treats the surfaces that the lanes may meet as one cell. Returns false if there are too many.
  bool go_by_boxes(V from, V to, M lanes, unsigned signs) {
    Cell cell;
    cell.tolerance = cells_.boxes.tolerance;
    cell.step_count = gathered_cell;
    Gatherer<D> gatherer(scene_, cells_, line_, departures_, events_, gathered_, counts_);
    const std::optional<std::size_t> slots = gatherer.gather(from, to, lanes, signs);
    if (!slots) return false;
    cell.slot_count = static_cast<std::uint8_t>(*slots);
    ++counts_.cells;
    const M starting = hn::And(lanes, hn::Le(from, line_.start));
    begun_ = hn::Or(begun_, lanes);
    if constexpr (hn::is_single<D>) {
      if (departures_ == nullptr && sweep_in_order(cell, from, to, starting)) return true;
    }
    // Lanes that are not certain are flagged even if no surface is left.
    look_into(cell, from, to, lanes, starting);
    return true;
  }
  /// Prevents the compiler from turning a branch into a selection, which would have to wait for its condition.
  static HWY_INLINE void keep_branch() { asm volatile(""); }

  /// Fetches the slots of an end's cell while the cell itself is being fetched; most cells have no more slots. Some
  /// cells have none. Then there is no slot at the address.
  HWY_INLINE void fetch_slots(const CellNode& end) const {
    constexpr std::size_t most = 4;
    const auto first = reinterpret_cast<std::uintptr_t>(cells_.slots.data()) + end.first_slot() * sizeof(Slot);
    for (std::size_t i = 0; i < most; ++i) hwy::Prefetch(reinterpret_cast<const Slot*>(first + i * sizeof(Slot)));
  }

  HWY_INLINE void descend(V from, V to, unsigned signs) {
    const D d;
    struct Rest {
      V from, to;
      std::uint32_t node;
    };
    Rest stack[most_depth];
    std::size_t height = 0;
    std::uint32_t at = 0;
    for (;;) {
      const CellNode* node = &cells_.nodes[at];
      while (!node->is_end()) {
        ++counts_.nodes;
        const unsigned axis = node->axis;
        const V split = tau_at(d, line_, axis, node->split);
        const V first_to = hn::Min(to, split);
        const V second_from = hn::Max(from, split);
        const bool upwards = ((signs >> axis) & 1) == 0;
        const std::uint32_t first = upwards ? at + 1 : node->above;
        const std::uint32_t second = upwards ? node->above : at + 1;
        // These are branches and not selections, because a packet usually goes the same way as the packet before it.
        if (hn::AllFalse(d, hn::Le(from, first_to))) {
          at = second;
          keep_branch();
        } else if (hn::AllFalse(d, hn::Le(second_from, to))) {
          at = first;
          keep_branch();
        } else {
          stack[height].from = second_from;
          stack[height].to = to;
          stack[height++].node = second;
          to = first_to;
          at = first;
        }
        node = &cells_.nodes[at];
      }
      const M active = hn::And(live_, hn::Le(from, to));
      if (!hn::AllFalse(d, active)) {
        fetch_slots(*node);
        visit(cells_.cells[node->above], from, to, active);
        if (hn::AllFalse(d, live_)) return;
      }
      for (;;) {
        if (height == 0) return;
        --height;
        from = stack[height].from;
        to = hn::IfThenElse(live_, stack[height].to, hn::Neg(hn::Inf(d)));
        if (!hn::AllFalse(d, hn::Le(from, to))) break;
      }
      at = stack[height].node;
    }
  }
  void visit(const Cell& cell, V from, V to, M active) {
    const D d;
    ++counts_.cells;
    if (cell.is_undecided) return flag(active);
    const M starting = hn::AndNot(begun_, hn::And(active, hn::Le(from, line_.start)));
    // A ray that enters from beyond comes from outside. Only a start within the cells has to be examined.
    begun_ = hn::Or(begun_, active);
    if (cell.slot_count == 0) {
      if (!hn::AllFalse(d, starting)) begin_in(starting, cell.value() ? starting : hn::Xor(starting, starting));
      // No surface is near the cell. The state on the way in must agree with that, unless something is wrong.
      covered_lanes_ = hn::AndNot(active, covered_lanes_);
      return flag(cell.value() ? hn::AndNot(now_inside_, active) : hn::And(now_inside_, active));
    }
    counts_.surface_tests += cell.slot_count;
    cell_events(d, scene_, line_, cells_, cell, departures_, events_);
    look_into(cell, from, to, active, starting);
  }

  static constexpr std::size_t most_depth = 72;

  PacketCounts& counts_;
};

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
