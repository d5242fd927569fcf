// SPDX-License-Identifier: MIT
// Finds the few conjunctions that lines may meet, in a hierarchy of boxes. Compiled once for each instruction set, by
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
/// Bounds, rounded outward, of all lines in some lanes: where they are near the frame's center, the inverses of their
/// directions, and where they start and end. On each axis the directions must have the same sign.
struct Beam {
  float front[3], back[3];  ///< subtracted from the sides of boxes where lines enter and leave; a single line uses only
                            ///< `front`, multiplied by its inverse
  float inverse_low[3], inverse_high[3];
  float from, to;
  unsigned falls;  ///< the axes along which the lines fall, one bit each
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
  // A line that is square to an axis stays on its side of every box within the range that matters.
  constexpr double most = 1e30;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if constexpr (hn::is_single<D>) {
      // The inverse is rounded to nearest. That moves a box by 2^-20 at most, which the widening of boxes covers.
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

/// The nodes and conjunctions that a beam has met. Nodes are visited in the order in which they were met, so that the
/// next node seldom waits for the result of this node's boxes.
struct Met {
  static constexpr std::size_t most_nodes = 256;

  // A whole node's children are written at once.
  std::uint32_t nodes[most_nodes + BoxNode::width];
  std::uint32_t conjunctions[Cell::most_slots + 2 * BoxNode::width];
  std::size_t node_count;
  std::size_t conjunction_count;

  /// Takes the balls out, and returns their number. Behind the last ball, `balls` is filled up with repeats.
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

/// Adds those of a node's boxes that some line of the beam may meet. Rounding may move them in space by less than
/// `widening` (box_tree.cpp): by 2^-21 for a place and as much for its product, because no two places are farther than
/// 8 apart.
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
    // It is unpredictable which boxes are met and what they contain, so there are no branches.
    const auto child = hh::Load(ids, node.child + first);
    const auto is_met = hh::RebindMask(ids, hh::Le(enters, leaves));
    const auto is_node = hh::Lt(child, hh::Set(ids, BoxNode::conjunction));
    put(ids, child, hh::And(is_met, is_node), met.nodes, node_count);
    put(ids, child, hh::AndNot(is_node, is_met), met.conjunctions, conjunction_count);
  }
}

/// Finds the conjunctions whose boxes the beam meets, in the form of BoxNode::child. Returns false if there are too
/// many.
template <bool is_single>
HWY_INLINE bool find_conjunctions(const BoxTree& tree, const Beam& beam, Met& met) {
  met.nodes[0] = 0;
  std::size_t node_count = 1;  // these variables stay in registers
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
