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
  float near_low[3], near_high[3];
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
    beam.near_low[axis] = rounded_down(least_of(d, lanes, near[axis]));
    beam.near_high[axis] = rounded_up(greatest_of(d, lanes, near[axis]));
    beam.inverse_low[axis] = rounded_down(std::fmax(-most, std::fmin(most, least_of(d, lanes, line.axis_inverse[axis]))));
    beam.inverse_high[axis] =
        rounded_up(std::fmax(-most, std::fmin(most, greatest_of(d, lanes, line.axis_inverse[axis]))));
  }
  beam.from = rounded_down(least_of(d, lanes, from));
  beam.to = rounded_up(greatest_of(d, lanes, to));
  beam.falls = falls;
}

/// The boxes of a node that some line of the beam may meet, a bit each. What rounding moves by less than `widening`
/// (box_tree.cpp), in space, does not matter: 2^-21 for a place and as much for its product, as nothing is farther than
/// 8 from another.
template <bool is_single>
HWY_INLINE unsigned boxes_met(const BoxNode& node, const Beam& beam) {
  const boxes::CappedTag<float, BoxNode::width> d;
  using V = boxes::Vec<decltype(d)>;
  unsigned met = 0;
  for (std::size_t first = 0; first < BoxNode::width; first += boxes::Lanes(d)) {
    V enters = boxes::Set(d, beam.from);
    V leaves = boxes::Set(d, beam.to);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool falls = ((beam.falls >> axis) & 1) != 0;
      const V lower = boxes::Load(d, node.lower[axis] + first);
      const V upper = boxes::Load(d, node.upper[axis] + first);
      const V to_front = boxes::Sub(falls ? upper : lower, boxes::Set(d, falls ? beam.near_low[axis] : beam.near_high[axis]));
      const V to_back = boxes::Sub(falls ? lower : upper, boxes::Set(d, falls ? beam.near_high[axis] : beam.near_low[axis]));
      const V low = boxes::Set(d, beam.inverse_low[axis]);
      const V high = boxes::Set(d, beam.inverse_high[axis]);
      if constexpr (is_single) {
        enters = boxes::Max(enters, boxes::Mul(to_front, low));
        leaves = boxes::Min(leaves, boxes::Mul(to_back, low));
      } else {
        enters = boxes::Max(enters, boxes::Min(boxes::Mul(to_front, low), boxes::Mul(to_front, high)));
        leaves = boxes::Min(leaves, boxes::Max(boxes::Mul(to_back, low), boxes::Mul(to_back, high)));
      }
    }
    std::uint8_t bits[8];
    boxes::StoreMaskBits(d, boxes::Le(enters, leaves), bits);
    met |= static_cast<unsigned>(bits[0]) << first;
  }
  return met;
}

/// One cell's worth of surfaces, and the tree's value over them.
struct Gathered {
  struct Part {
    std::uint64_t mask, want;
    bool is_subtracted;
  };

  std::uint32_t conjunctions[Cell::most_slots];
  std::size_t conjunction_count;
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

constexpr std::size_t most_waiting = 192;

/// The conjunctions whose boxes the beam meets; false if there are too many.
template <bool is_single>
HWY_INLINE bool gather(const BoxTree& tree, const Beam& beam, Gathered& gathered, PacketCounts& counts) {
  std::uint32_t waiting[most_waiting];
  std::size_t height = 0;
  std::size_t count = 0;
  std::uint32_t at = 0;
  for (;;) {
    ++counts.nodes;
    const BoxNode& node = tree.nodes[at];
    for (unsigned met = boxes_met<is_single>(node, beam); met != 0; met &= met - 1) {
      const std::uint32_t child = node.child[static_cast<std::size_t>(__builtin_ctz(met))];
      if ((child & BoxNode::conjunction) == 0) {
        if (height == most_waiting) return false;
        waiting[height++] = child;
      } else {
        if (count == Cell::most_slots) return false;
        gathered.conjunctions[count++] = child & ~BoxNode::conjunction;
      }
    }
    if (height == 0) break;
    at = waiting[--height];
  }
  gathered.conjunction_count = count;
  return true;
}

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
