// SPDX-License-Identifier: MIT
// What lines gather from a hierarchy of boxes: the surfaces of the few conjunctions that they may meet, and the tree's
// value over these. Compiled once for each instruction set; included by lanes.cpp only.
#if defined(CSGCAST_LANE_BOXES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_BOXES_INL_H
#undef CSGCAST_LANE_BOXES_INL_H
#else
#define CSGCAST_LANE_BOXES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {
namespace boxes = hwy::HWY_NAMESPACE;

/// What holds all lines of some lanes: where they are near the frame's center, the inverses of their directions, and
/// where they start and end. Rounded outward; their directions have one sign on each axis.
struct Beam {
  float front[3], back[3];  ///< what to take from the sides of boxes where lines come in and leave
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
    return boxes::GetLane(boxes::MinOfLanes(d, hn::IfThenElse(lanes, v, hn::Inf(d))));
  }
}

template <class D>
HWY_INLINE double greatest_of(D d, hn::Mask<D> lanes, hn::Vec<D> v) {
  if constexpr (hn::is_single<D>) {
    return v;
  } else {
    return boxes::GetLane(boxes::MaxOfLanes(d, hn::IfThenElse(lanes, v, hn::Neg(hn::Inf(d)))));
  }
}

template <class D>
HWY_INLINE void set_beam(D d, const LineLanes<D>& line, hn::Mask<D> lanes, unsigned falls, hn::Vec<D> from,
                         hn::Vec<D> to, Beam& beam) {
  const hn::Vec<D> near[3] = {line.walk_near.x, line.walk_near.y, line.walk_near.z};
  // A line across an axis stays on its side of every box for as long as anybody looks.
  constexpr double most = 1e30;
  for (std::size_t axis = 0; axis < 3; ++axis) {
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
};

/// Adds those of a node's boxes that some line of the beam may meet. What rounding moves by less than `widening`
/// (box_tree.cpp), in space, does not matter: 2^-21 for a place and as much for its product, as nothing is farther than
/// 8 from another.
template <bool is_single>
HWY_INLINE void add_boxes(const BoxNode& node, const Beam& beam, Met& met) {
  const boxes::CappedTag<float, BoxNode::width> d;
  const boxes::RebindToUnsigned<decltype(d)> ids;
  using V = boxes::Vec<decltype(d)>;
  for (std::size_t first = 0; first < BoxNode::width; first += boxes::Lanes(d)) {
    V enters = boxes::Set(d, beam.from);
    V leaves = boxes::Set(d, beam.to);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool falls = ((beam.falls >> axis) & 1) != 0;
      const V lower = boxes::Load(d, node.lower[axis] + first);
      const V upper = boxes::Load(d, node.upper[axis] + first);
      const V front = boxes::Sub(falls ? upper : lower, boxes::Set(d, beam.front[axis]));
      const V back = boxes::Sub(falls ? lower : upper, boxes::Set(d, beam.back[axis]));
      const V low = boxes::Set(d, beam.inverse_low[axis]);
      if constexpr (is_single) {
        enters = boxes::Max(enters, boxes::Mul(front, low));
        leaves = boxes::Min(leaves, boxes::Mul(back, low));
      } else {
        const V high = boxes::Set(d, beam.inverse_high[axis]);
        enters = boxes::Max(enters, boxes::Min(boxes::Mul(front, low), boxes::Mul(front, high)));
        leaves = boxes::Min(leaves, boxes::Max(boxes::Mul(back, low), boxes::Mul(back, high)));
      }
    }
    // Which boxes are met, and what is in them, nobody could foresee: no branches.
    const auto child = boxes::Load(ids, node.child + first);
    const auto is_met = boxes::RebindMask(ids, boxes::Le(enters, leaves));
    const auto is_node = boxes::Lt(child, boxes::Set(ids, BoxNode::conjunction));
    met.node_count += boxes::CompressStore(child, boxes::And(is_met, is_node), ids, met.nodes + met.node_count);
    met.conjunction_count +=
        boxes::CompressStore(child, boxes::AndNot(is_node, is_met), ids, met.conjunctions + met.conjunction_count);
  }
}

/// Finds the conjunctions whose boxes the beam meets; false if there are too many. Their ids have
/// BoxNode::conjunction in them.
template <bool is_single>
HWY_INLINE bool find_conjunctions(const BoxTree& tree, const Beam& beam, Met& met) {
  met.nodes[0] = 0;
  met.node_count = 1;
  met.conjunction_count = 0;
  for (std::size_t next = 0; next < met.node_count; ++next) {
    add_boxes<is_single>(tree.nodes[met.nodes[next]], beam, met);
    if (met.node_count > Met::most_nodes || met.conjunction_count > Cell::most_slots) return false;
  }
  return true;
}

/// One cell's worth of surfaces, and the tree's value over them.
struct Gathered {
  struct Part {
    std::uint64_t mask, want;
    bool is_subtracted;
  };

  std::uint32_t slots[Cell::most_slots];  ///< of their surfaces
  /// Conjunctions of one surface that nothing else has: inside where the state differs from `flipped`.
  std::uint64_t united, subtracted, flipped;
  Part parts[Cell::most_slots];  ///< the other ones
  std::size_t part_count;

  HWY_INLINE void begin() {
    united = subtracted = flipped = 0;
    part_count = 0;
  }
  /// Which of the first `count` slots it is; `count` if none.
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

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
