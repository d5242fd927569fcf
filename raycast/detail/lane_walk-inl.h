// SPDX-License-Identifier: MIT
// Rays through the cells, a ray a lane, front to back. Compiled once for each instruction set; included by lanes.cpp
// only.
#if defined(CSGCAST_LANE_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_WALK_INL_H
#undef CSGCAST_LANE_WALK_INL_H
#else
#define CSGCAST_LANE_WALK_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

enum class Wanted : std::uint8_t { first, any, all };

/// One packet's way through the cells. A lane is live until its answer is known; what happens to it is in `fate`.
template <class D, Wanted wanted>
class Walk {
 public:
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  using Bits = BitsOf<D>;
  using U = hn::Vec<Bits>;

  Walk(const Scene& scene, const CellData& cells, const LineLanes<D>& line, const Departures<D>* departures,
       EndLog<D>* ends, PacketCounts& counts)
      : scene_(scene), cells_(cells), line_(line), departures_(departures), ends_(ends), counts_(counts) {}

  /// Nothing is found yet.
  HWY_INLINE void begin() {
    const V zero = hn::Zero(D());
    flagged_ = found_ = begun_ = now_inside_ = started_inside_ = unrounded_ = hn::MaskFromVec(zero);
    if constexpr (wanted == Wanted::all) ends_->clear();
    slot_ = count_ = hn::Zero(Bits());
    rises_ = covered_lanes_ = found_;
    covered_ = zero;
  }

  /// `lanes`: those that hold a ray.
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
      clip(from, to);
    }
    M waiting = hn::And(live_, hn::Le(from, to));
    if constexpr (hn::is_single<D>) {
      if (waiting) go(from, to, waiting, signs_of(0));
      return;
    }
    // Lanes of one direction's signs at a time: these share the order of the cells.
    while (!hn::AllFalse(d, waiting)) {
      const std::size_t leader = static_cast<std::size_t>(hn::FindFirstTrue(d, waiting));
      const unsigned signs = signs_of(leader);
      M group = waiting;
      for (unsigned axis = 0; axis < 3; ++axis) {
        const M negative = hn::Lt(line_.axis_inverse[axis], hn::Zero(d));
        group = ((signs >> axis) & 1) != 0 ? hn::And(group, negative) : hn::AndNot(negative, group);
      }
      waiting = hn::AndNot(group, waiting);
      go(from, to, group, signs);
    }
  }

  /// Whether t of ends is to be the nearest double, where lanes can tell.
  void set_rounds(bool rounds) { rounds_ = rounds; }
  /// Whether normals of ends are wanted.
  void set_wants_normals(bool wants) { wants_normals_ = wants; }

  M flagged() const { return flagged_; }
  M found() const { return found_; }        ///< the lanes that have an answer but a miss
  M inside() const { return now_inside_; }  ///< of those: that are inside right after
  M started_inside() const { return started_inside_; }
  U slot() const { return slot_; }
  M rises() const { return rises_; }  ///< the surface turns positive
  U end_count() const { return count_; }
  M unrounded() const { return unrounded_; }  ///< the lanes with some end whose t lanes could not round

 private:
  HWY_INLINE unsigned signs_of(std::size_t lane) const {
    const D d;
    unsigned signs = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
      HWY_ALIGN double values[16];
      hn::Store(line_.axis_inverse[axis], d, values);
      signs |= static_cast<unsigned>(values[lane] < 0) << axis;
    }
    return signs;
  }

  /// Lanes of one direction's signs.
  HWY_INLINE void go(V from, V to, M lanes, unsigned signs) {
    if (uses_boxes && !cells_.boxes.nodes.empty() && go_by_boxes(from, to, lanes, signs)) return;
    descend(from, hn::IfThenElse(lanes, to, hn::Neg(hn::Inf(D()))), signs);
  }

  /// As if all were one cell, with the surfaces of what the lanes may meet; false if these are too many.
  bool go_by_boxes(V from, V to, M lanes, unsigned signs) {
    const D d;
    Beam beam;
    set_beam(d, line_, lanes, signs, from, to, beam);
    const bool are_few = find_conjunctions<hn::is_single<D>>(cells_.boxes, beam, met_);
    counts_.nodes += met_.node_count;
    if (!are_few) return false;
    Cell cell;
    cell.slack = cells_.boxes.slack;
    cell.may_have_twins = cells_.boxes.may_have_twins;
    cell.step_count = gathered_cell;
    if (!gather_events(from, to, lanes, cell)) return false;
    ++counts_.cells;
    const M starting = hn::And(lanes, hn::Le(from, line_.start));
    begun_ = hn::Or(begun_, lanes);
    if (met_.conjunction_count != 0) look_into(cell, from, to, lanes, starting);
    return true;
  }

  /// The events of the surfaces of all conjunctions that were gathered, but for those that the lanes miss; false if
  /// they are too many.
  HWY_INLINE bool gather_events(V from, V to, M lanes, Cell& cell) {
    const D d;
    const BoxTree& tree = cells_.boxes;
    clear_events(d, line_, cell.slack, events_);
    gathered_.begin();
    const V margin = hn::Set(d, 4 * greatest_slack);
    const Stretch stretch{hn::Sub(from, margin), hn::Add(to, margin), lanes};
    std::size_t count = 0;
    for (std::size_t k = 0; k < met_.conjunction_count; ++k) {
      const Conjunction& conjunction = tree.conjunctions[met_.conjunctions[k] - BoxNode::conjunction];
      if (count + conjunction.count > Cell::most_slots) return false;
      if (conjunction.count == 1) {
        count = add_simple(tree, conjunction, stretch, count);
      } else {
        count = add_conjunction(tree, conjunction, stretch, count);
      }
    }
    cell.slot_count = static_cast<std::uint8_t>(count);
    return true;
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

  /// Forgets events that were computed from some place on.
  HWY_INLINE void forget_events(std::size_t from, std::size_t to) {
    const std::uint64_t kept = ~((std::uint64_t{1} << to) - (std::uint64_t{1} << from));
    events_.before = hn::And(events_.before, hn::Set(Bits(), kept));
  }

  /// A conjunction of one surface. Returns how many slots there are then.
  HWY_INLINE std::size_t add_simple(const BoxTree& tree, const Conjunction& conjunction, const Stretch& stretch,
                                    std::size_t count) {
    const BoxedSide& side = tree.sides[conjunction.first];
    if (side.is_shared) return add_conjunction(tree, conjunction, stretch, count);
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
    gathered_.united |= conjunction.is_subtracted ? 0 : bit;
    gathered_.subtracted |= conjunction.is_subtracted ? bit : 0;
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

  HWY_INLINE std::uint32_t slot_of(const Cell& cell, std::size_t i) const {
    return is_gathered(cell) ? gathered_.slots[i] : cell.first_slot + static_cast<std::uint32_t>(i);
  }

  HWY_INLINE U state_at(const Cell& cell, V at) const { return event_state(D(), events_, cell, at); }
  HWY_INLINE M value_of(const Cell& cell, U state) const {
    return cell.step_count == 0 ? value_by_table(D(), cell, state) : value_of_large(cell, state);
  }
  HWY_NOINLINE M value_of_large(const Cell& cell, U state) const {
    const auto value =
        is_gathered(cell) ? gathered_value(D(), gathered_, state) : value_by_steps(D(), cells_, cell, state);
    return hn::RebindMask(D(), value);
  }
  static HWY_INLINE bool is_gathered(const Cell& cell) { return uses_boxes && cell.step_count == gathered_cell; }

  HWY_INLINE void clip(V& from, V& to) const {
    const D d;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const V low = tau_at(d, line_, axis, cells_.box.lower[axis]);
      const V high = tau_at(d, line_, axis, cells_.box.upper[axis]);
      from = hn::Max(from, hn::Min(low, high));
      to = hn::Min(to, hn::Max(low, high));
    }
  }

  HWY_INLINE void flag(M lanes) {
    if constexpr (!certified) return;
    if (hn::AllFalse(D(), lanes)) return;
    flagged_ = hn::Or(flagged_, lanes);
    live_ = hn::AndNot(lanes, live_);
  }

  /// Keeps the compiler from making a branch a selection, which would wait for its condition.
  static HWY_INLINE void keep_branch() { asm volatile(""); }

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
        // Branches, not selections: where a packet goes is seldom a surprise after the one before it.
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

  /// Lanes that start inside the cell learn what they start in.
  HWY_INLINE void begin_in(M lanes, M inside) {
    now_inside_ = hn::Or(hn::AndNot(lanes, now_inside_), hn::And(lanes, inside));
    started_inside_ = hn::Or(started_inside_, hn::And(lanes, inside));
    if constexpr (wanted == Wanted::any) {
      found_ = hn::Or(found_, hn::And(lanes, inside));
      live_ = hn::AndNot(hn::And(lanes, inside), live_);
    }
  }

  void visit(const Cell& cell, V from, V to, M active) {
    const D d;
    ++counts_.cells;
    if (cell.is_undecided) return flag(active);
    const M starting = hn::AndNot(begun_, hn::And(active, hn::Le(from, line_.start)));
    // Whoever comes in from beyond comes from outside: only a start within the cells needs to be looked at.
    begun_ = hn::Or(begun_, active);
    if (cell.slot_count == 0) {
      if (!hn::AllFalse(d, starting)) begin_in(starting, cell.value ? starting : hn::Xor(starting, starting));
      // No surface is near the cell. The state on the way in must agree: it does, unless something is wrong.
      covered_lanes_ = hn::AndNot(active, covered_lanes_);
      return flag(cell.value ? hn::AndNot(now_inside_, active) : hn::And(now_inside_, active));
    }
    counts_.surface_tests += cell.slot_count;
    cell_events(d, scene_, line_, cells_, cell, departures_, events_);
    look_into(cell, from, to, active, starting);
  }

  /// What the lanes meet in a cell whose events are known.
  HWY_INLINE void look_into(const Cell& cell, V from, V to, M active, M starting) {
    const D d;
    known_crossings_ = 0;
    if constexpr (certified) {
      flag(hn::And(active, events_.flagged));
      if (cell.may_have_twins) flag(hn::And(active, twins(d, events_, cell, from, to)));
      active = hn::And(active, live_);
    }
    if (!hn::AllFalse(d, hn::And(starting, live_))) start(cell, hn::And(starting, live_));
    sweep(cell, from, to, hn::And(active, live_));
  }

  /// What lanes start in; those with an event at the start are flagged.
  void start(const Cell& cell, M lanes) {
    const D d;
    const U after = state_at(cell, hn::Add(line_.start, events_.slack));
    if constexpr (!certified) return begin_in(lanes, value_of(cell, after));
    const U before = state_at(cell, hn::Sub(line_.start, events_.slack));
    const M differs = hn::And(lanes, hn::RebindMask(d, hn::Ne(before, after)));
    flag(differs);
    begin_in(hn::AndNot(differs, lanes), value_of(cell, after));
  }

  /// Event by event, as long as some lane has one in the cell. An event counts as certain if no other is within slack
  /// of it.
  HWY_INLINE void sweep(const Cell& cell, V from, V to, M active) {
    const D d;
    const V slack = events_.slack;
    V limit = hn::Add(to, slack);
    // Finite: an event at infinity is none.
    if (cells_.reaches_beyond) limit = hn::Min(limit, hn::Set(d, std::numeric_limits<double>::max()));
    // The last cell looked at events up to its own slack beyond the border: this one goes on from there.
    V at = hn::IfThenElse(covered_lanes_, covered_, hn::Add(from, slack));
    covered_ = hn::IfThenElse(active, hn::Max(limit, at), covered_);
    covered_lanes_ = hn::Or(covered_lanes_, active);
    V next = next_event(d, events_, cell, at);
    // The lanes with an event to look at. Close to the end of what is asked nothing is certain.
    const auto due = [&](M lanes) {
      const M todo = hn::And(lanes, hn::Le(next, limit));
      if (line_.ends) flag(hn::And(todo, hn::Gt(next, hn::Sub(line_.end, hn::Add(slack, line_.end_error)))));
      return hn::And(todo, live_);
    };
    M todo = due(active);
    if (hn::AllFalse(d, todo)) return;
    U state = state_at(cell, at);
    if constexpr (certified) {
      const M disagrees = hn::And(todo, hn::Xor(value_of(cell, state), now_inside_));
      flag(disagrees);
      todo = hn::AndNot(disagrees, todo);
    }
    while (!hn::AllFalse(d, todo)) {
      const U after = state_at(cell, hn::Add(next, slack));
      U flips = hn::Xor(state, after);
      const M value = value_of(cell, after);
      M changes = hn::And(todo, hn::Xor(value, now_inside_));
      if constexpr (certified) {
        const M several = hn::AndNot(has_one_bit(d, flips), todo);
        if (!hn::AllFalse(d, several)) {
          settle(cell, state, after, next, several, flips);
          todo = hn::And(todo, live_);
          changes = hn::And(changes, live_);
        }
      }
      record(cell, changes, flips, after);
      state = after;
      now_inside_ = hn::Or(hn::AndNot(changes, now_inside_), hn::And(changes, value));
      at = hn::Add(next, slack);
      next = next_event(d, events_, cell, at);
      todo = due(hn::And(todo, live_));
    }
  }

  /// Two surfaces flip within slack of each other: it does not matter in which order if the value is the same in
  /// between, or if one of them alone decides it both before and after. All else is flagged. `flips` becomes the one
  /// that decides.
  void settle(const Cell& cell, U state, U after, V next, M several, U& flips) {
    const D d;
    const Bits bits;
    const U low = hn::And(flips, hn::Sub(hn::Zero(bits), flips));
    const U high = hn::Xor(flips, low);
    const U later = state_at(cell, hn::Add(next, hn::Add(events_.slack, events_.slack)));
    const M is_pair = hn::And(has_one_bit(d, high), hn::RebindMask(d, hn::Eq(later, after)));
    const M before_value = now_inside_;
    const M after_value = value_of(cell, after);
    const M low_value = value_of(cell, hn::Xor(state, low));
    const M high_value = value_of(cell, hn::Xor(state, high));
    const M low_changes = hn::Xor(before_value, low_value);
    const M high_changes = hn::Xor(before_value, high_value);
    const M changes = hn::Xor(before_value, after_value);
    const M none = hn::AndNot(changes, hn::Not(hn::Or(low_changes, high_changes)));
    const M by_low = hn::And(changes, hn::AndNot(high_changes, low_changes));
    const M by_high = hn::And(changes, hn::AndNot(low_changes, high_changes));
    const M settled = hn::And(is_pair, hn::Or(none, hn::Or(by_low, by_high)));
    flag(hn::AndNot(settled, several));
    const auto in_bits = [&](M lanes) { return hn::RebindMask(bits, hn::And(several, lanes)); };
    flips = hn::IfThenElse(in_bits(by_low), low, hn::IfThenElse(in_bits(by_high), high, flips));
  }

  HWY_INLINE void record(const Cell& cell, M changes, U flips, U after) {
    const Bits bits;
    if (hn::AllFalse(D(), changes)) return;
    const auto lanes = hn::RebindMask(bits, changes);
    const U index = logarithm(D(), flips);
    const M rises = hn::RebindMask(D(), hn::Ne(hn::And(flips, after), hn::Zero(bits)));
    if constexpr (wanted == Wanted::all) return append(cell, changes, index, rises, hn::Not(now_inside_));
    slot_ = hn::IfThenElse(lanes, slots_of(cell, index), slot_);
    rises_ = hn::Or(rises_, hn::And(changes, rises));
    found_ = hn::Or(found_, changes);
    live_ = hn::AndNot(changes, live_);
  }

  HWY_INLINE U slots_of(const Cell& cell, U index) const {
    const Bits bits;
    if (!is_gathered(cell)) return hn::Add(hn::Set(bits, cell.first_slot), index);
    HWY_ALIGN std::uint64_t slots[16];
    hn::Store(index, bits, slots);
    for (std::size_t lane = 0; lane < hn::Lanes(D()); ++lane) {
      // Of lanes that found nothing the index means nothing.
      slots[lane] = gathered_.slots[slots[lane] < Cell::most_slots ? slots[lane] : 0];
    }
    return hn::Load(bits, slots);
  }

  /// crossing_tau: both crossings of a quadric are computed at once, as both are likely to be wanted.
  HWY_INLINE V end_tau(const Cell& cell, const Surface& surface, std::uint64_t i, M own, M rises, M& second,
                       M& is_open) {
    const D d;
    if (!is_gathered(cell) || surface.kind == SurfaceKind::plane || !hn::AllFalse(d, own))
      return crossing_tau(d, line_, surface, own, rises, second, is_open);
    if (((known_crossings_ >> i) & 1) == 0) {
      crossings_[i] = crossings_of(d, quadratic(d, line_, surface), line_, surface);
      known_crossings_ |= std::uint64_t{1} << i;
    }
    return crossing_tau(d, crossings_[i], surface, rises, second, is_open);
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
      M second, is_open;
      const Surface& surface = scene_.surfaces()[id];
      const M own_surface = own_lanes(d, departures_, id);
      const V tau = end_tau(cell, surface, i, own_surface, rises, second, is_open);
      flag(hn::And(same, is_open));
      V own = hn::Mul(hn::Add(line_.shift, tau), line_.unit);
      if (rounds_) {
        V nearest;
        const M certain = hn::AndNot(own_surface, nearest_t_lanes(d, line_, surface, tau, nearest));
        own = hn::IfThenElse(certain, nearest, own);
        unrounded_ = hn::Or(unrounded_, hn::AndNot(certain, same));
      }
      t = hn::IfThenElse(same, own, t);
      const U root = hn::IfThenElseZero(hn::RebindMask(bits, second), hn::Set(bits, std::uint64_t{1} << 32));
      const auto in_bits = hn::RebindMask(bits, same);
      where = hn::IfThenElse(in_bits, hn::Or(hn::Set(bits, id), root), where);
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

  static constexpr std::size_t most_depth = 72;
  static constexpr bool uses_boxes = wanted == Wanted::all;
  static constexpr std::uint16_t gathered_cell = 0xffff;  // its steps: the cell is what was gathered

  const Scene& scene_;
  const CellData& cells_;
  const LineLanes<D>& line_;
  const Departures<D>* departures_;
  EndLog<D>* ends_;
  PacketCounts& counts_;
  Events<D> events_;
  Crossings<D> crossings_[Cell::most_slots];  // of the surfaces of the cell that are known
  std::uint64_t known_crossings_ = 0;
  Met met_;
  Gathered gathered_;
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
