// SPDX-License-Identifier: MIT
// The few conjunctions that lines may meet, from a hierarchy of boxes. Compiled once for each instruction set, by
// lanes.cpp.
#if defined(CSGCAST_LANE_BOXES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_BOXES_INL_H
#undef CSGCAST_LANE_BOXES_INL_H
#else
#define CSGCAST_LANE_BOXES_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "raycast/cells/build/cell_data.h"
#include "raycast/packets/detail/lane_line-inl.h"
#include "raycast/packets/detail/lane_order-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {
/// What holds all lines of some lanes: where they are near the frame's center, the inverses of their directions, and
/// where they start and end. Rounded outward; their directions have one sign on each axis.
struct Beam {
  float front[3], back[3];  ///< what to take from the sides of boxes where lines come in and leave; of a single line
                            ///< `front` alone, and times its inverse
  float inverse_low[3], inverse_high[3];
  float from, to;
  unsigned falls;  ///< the axes along which they do
};

HWY_INLINE float rounded_down(double x) { return static_cast<float>(x - std::fabs(x) * 0x1p-23); }
HWY_INLINE float rounded_up(double x) { return static_cast<float>(x + std::fabs(x) * 0x1p-23); }

template <class D>
HWY_INLINE double least_of(D d, hn::Mask<D> lanes, hn::Vec<D> v) {
  if constexpr (hn::is_single<D>) {
    return v;
  } else {
    return hh::GetLane(hh::MinOfLanes(d, hn::IfThenElse(lanes, v, hn::Inf(d))));
  }
}

template <class D>
HWY_INLINE double greatest_of(D d, hn::Mask<D> lanes, hn::Vec<D> v) {
  if constexpr (hn::is_single<D>) {
    return v;
  } else {
    return hh::GetLane(hh::MaxOfLanes(d, hn::IfThenElse(lanes, v, hn::Neg(hn::Inf(d)))));
  }
}

template <class D>
HWY_INLINE void set_beam(D d, const LineLanes<D>& line, hn::Mask<D> lanes, unsigned falls, hn::Vec<D> from,
                         hn::Vec<D> to, Beam& beam) {
  const hn::Vec<D> near[3] = {line.walk_near.x, line.walk_near.y, line.walk_near.z};
  // A line across an axis stays on its side of every box for as long as anybody looks.
  constexpr double most = 1e30;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if constexpr (hn::is_single<D>) {
      // Rounded to nearest, which moves a box by 2^-20 at most: its widening is for that.
      const double inverse = line.axis_inverse[axis];
      const double bounded = inverse < -most ? -most : inverse > most ? most : inverse;
      beam.front[axis] = static_cast<float>(near[axis] * bounded);
      beam.inverse_low[axis] = static_cast<float>(bounded);
      continue;
    }
    const float least = rounded_down(least_of(d, lanes, near[axis]));
    const float greatest = rounded_up(greatest_of(d, lanes, near[axis]));
    const bool is_falling = ((falls >> axis) & 1) != 0;
    beam.front[axis] = is_falling ? least : greatest;
    beam.back[axis] = is_falling ? greatest : least;
    beam.inverse_low[axis] =
        rounded_down(std::fmax(-most, std::fmin(most, least_of(d, lanes, line.axis_inverse[axis]))));
    beam.inverse_high[axis] =
        rounded_up(std::fmax(-most, std::fmin(most, greatest_of(d, lanes, line.axis_inverse[axis]))));
  }
  beam.from = rounded_down(least_of(d, lanes, from));
  beam.to = rounded_up(greatest_of(d, lanes, to));
  beam.falls = falls;
}

/// What a beam has met: nodes, first come, first served, so that the next one seldom waits for what this one's boxes
/// say, and conjunctions.
struct Met {
  static constexpr std::size_t most_nodes = 256;

  // Whole nodes are written at once.
  std::uint32_t nodes[most_nodes + BoxNode::width];
  std::uint32_t conjunctions[Cell::most_slots + 2 * BoxNode::width];
  std::size_t node_count;
  std::size_t conjunction_count;

  /// Takes those out that are balls: how many there are, and behind them some more of the same.
  HWY_INLINE std::size_t take_balls(std::uint32_t* balls) {
    const hh::CappedTag<std::uint32_t, 8> d;
    const auto ball = hh::Set(d, BoxNode::ball);
    std::size_t ball_count = 0;
    std::size_t others = 0;
    for (std::size_t i = 0; i < conjunction_count; i += hh::Lanes(d)) {
      const auto ids = hh::LoadU(d, conjunctions + i);
      const auto is_there = hh::FirstN(d, conjunction_count - i);
      const auto is_ball = hh::Eq(hh::And(ids, ball), ball);
      put(d, ids, hh::And(is_there, is_ball), balls, ball_count);
      put(d, ids, hh::AndNot(is_ball, is_there), conjunctions, others);
    }
    conjunction_count = others;
    for (std::size_t i = 0; i < 8; i += hh::Lanes(d)) hh::StoreU(hh::Set(d, balls[0]), d, balls + ball_count + i);
    return ball_count;
  }
};

/// Adds those of a node's boxes that some line of the beam may meet. What rounding moves by less than `widening`
/// (box_tree.cpp), in space, does not matter: 2^-21 for a place and as much for its product, as nothing is farther than
/// 8 from another.
template <bool is_single>
HWY_INLINE void add_boxes(const BoxNode& node, const Beam& beam, Met& met, std::size_t& node_count,
                          std::size_t& conjunction_count) {
  const hh::CappedTag<float, BoxNode::width> d;
  const hh::RebindToUnsigned<decltype(d)> ids;
  using V = hh::Vec<decltype(d)>;
  for (std::size_t first = 0; first < BoxNode::width; first += hh::Lanes(d)) {
    V enters = hh::Set(d, beam.from);
    V leaves = hh::Set(d, beam.to);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t falls = (beam.falls >> axis) & 1;
      const V from = hh::Load(d, node.side[falls][axis] + first);
      const V to = hh::Load(d, node.side[1 - falls][axis] + first);
      const V low = hh::Set(d, beam.inverse_low[axis]);
      if constexpr (is_single) {
        const V offset = hh::Set(d, beam.front[axis]);
        enters = hh::Max(enters, hh::MulSub(from, low, offset));
        leaves = hh::Min(leaves, hh::MulSub(to, low, offset));
      } else {
        const V front = hh::Sub(from, hh::Set(d, beam.front[axis]));
        const V back = hh::Sub(to, hh::Set(d, beam.back[axis]));
        const V high = hh::Set(d, beam.inverse_high[axis]);
        enters = hh::Max(enters, hh::Min(hh::Mul(front, low), hh::Mul(front, high)));
        leaves = hh::Min(leaves, hh::Max(hh::Mul(back, low), hh::Mul(back, high)));
      }
    }
    // Which boxes are met, and what is in them, nobody could foresee: no branches.
    const auto child = hh::Load(ids, node.child + first);
    const auto is_met = hh::RebindMask(ids, hh::Le(enters, leaves));
    const auto is_node = hh::Lt(child, hh::Set(ids, BoxNode::conjunction));
    put(ids, child, hh::And(is_met, is_node), met.nodes, node_count);
    put(ids, child, hh::AndNot(is_node, is_met), met.conjunctions, conjunction_count);
  }
}

/// Finds the conjunctions whose boxes the beam meets, as BoxNode::child has them; false if there are too many.
template <bool is_single>
HWY_INLINE bool find_conjunctions(const BoxTree& tree, const Beam& beam, Met& met) {
  met.nodes[0] = 0;
  std::size_t node_count = 1;  // these stay in registers
  std::size_t conjunction_count = 0;
  const BoxNode* const nodes = tree.nodes.data();
  for (std::size_t next = 0; next < node_count; ++next) {
    add_boxes<is_single>(nodes[met.nodes[next]], beam, met, node_count, conjunction_count);
    if (node_count > Met::most_nodes || conjunction_count > Cell::most_slots) break;
  }
  met.node_count = node_count;
  met.conjunction_count = conjunction_count;
  return node_count <= Met::most_nodes && conjunction_count <= Cell::most_slots;
}

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
