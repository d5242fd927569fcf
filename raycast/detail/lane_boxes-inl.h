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

/// One cell's worth of surfaces, and the tree's value over them.
struct Gathered {
  struct Part {
    std::uint64_t mask, want;
    bool is_subtracted;
  };

  std::uint32_t slots[Cell::most_slots + 8];  ///< of their surfaces; registers reach beyond
  /// Conjunctions of one surface that nothing else has: inside where the state differs from `flipped`.
  std::uint64_t united, subtracted, flipped;
  Part parts[Cell::most_slots];  ///< the other ones
  std::size_t part_count;
  // Of a single ray, if it has them:
  bool has_line_events;
  std::uint64_t line_state;  ///< where the stretch begins that is looked at
  LineEvents line_events;    ///< on that

  HWY_INLINE void begin() {
    united = subtracted = flipped = 0;
    part_count = 0;
    line_events.count = 0;
    line_state = 0;
    has_line_events = false;
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

/// Finds what the lines of some lanes may meet, and the events of its surfaces.
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

  /// Between two places, of lanes of one direction's signs: how many surfaces there are; nothing if too many.
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
  /// The events of the surfaces of all conjunctions that were gathered, but for those that the lanes miss: how many
  /// surfaces; nothing if too many.
  HWY_INLINE std::optional<std::size_t> gather_events(V from, V to, M lanes) {
    const D d;
    const BoxTree& tree = cells_.boxes;
    clear_events(d, line_, tree.slack, events_);
    gathered_.begin();
    const V margin = hn::Set(d, 4 * greatest_slack);
    const Stretch stretch{hn::Sub(from, margin), hn::Add(to, margin), lanes};
    std::size_t count = 0;
    if constexpr (hn::is_single<D>) {
      if (departures_ == nullptr) count = add_balls(stretch);
    }
    const std::size_t ball_count = count;
    const bool knows_bricks = hn::is_single<D> && departures_ == nullptr && !line_.any_is_loose;
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
      if (knows_bricks && conjunction.brick != Conjunction::no_brick) {
        if (add_brick(tree.bricks[conjunction.brick], conjunction.is_subtracted, stretch, count)) continue;
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

  /// The part of their lines that lanes look at.
  struct Stretch {
    V from, to;
    M lanes;
  };

  /// What a surface does on the stretch.
  struct Course {
    M meets;     ///< it is crossed
    M positive;  ///< at the start of the stretch
  };

  /// Computes a surface's events, as those at some place.
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

  /// The spheres that a single ray may meet, as the first slots: how many of these they take. Some are left empty.
  HWY_INLINE std::size_t add_balls(const Stretch& stretch) {
    const SlotLanes d;
    const BitsOf<SlotLanes> bits;
    const hh::Rebind<std::uint32_t, SlotLanes> ids;
    const std::size_t lanes = hh::Lanes(d);
    std::uint32_t balls[Cell::most_slots + 24];
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

  /// The planes by which a single ray comes into a brick and leaves it, if it does on the stretch; false, and nothing
  /// done, if other planes are too close to them.
  HWY_INLINE bool add_brick(const Brick& brick, bool is_subtracted, const Stretch& stretch, std::size_t& count) {
    if constexpr (hn::is_single<D>) {
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
    } else {
      (void)brick, (void)is_subtracted, (void)stretch, (void)count;
      return false;
    }
  }

  /// The events of the slots [from, to) join those of the balls.
  HWY_INLINE void add_line_events(const Stretch& stretch, std::size_t from, std::size_t to) {
    const std::uint64_t balls = (std::uint64_t{1} << from) - 1;
    gathered_.line_state |= events_.before & ~balls;
    for (std::size_t i = from; i < to; ++i) {
      for (const double event : {events_.first[i], events_.second[i]}) {
        gathered_.line_state ^= std::uint64_t{event < stretch.from} << i;
        gathered_.line_events.add(event, i, (event >= stretch.from) & (event <= stretch.to));
      }
    }
    gathered_.has_line_events = true;
  }

  /// A conjunction of one surface, which no other one has. Returns how many slots there are then.
  HWY_INLINE std::size_t add_simple(const BoxedSide& side, bool is_subtracted, const Stretch& stretch,
                                    std::size_t count) {
    const Course course = course_of(cells_.slots[side.slot], stretch, count);
    const M holds = side.wants_positive ? course.positive : hn::Not(course.positive);
    // Whether some lane meets it is hard to foresee: packets go on without a branch.
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

  /// One of several surfaces: those matter that the lanes cross on the stretch, unless they are on the wrong side of
  /// another all along.
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
  unsigned signs_ = 0;  ///< of the lines' directions: the axes along which they fall
  Met met_;
};

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
