// SPDX-License-Identifier: MIT
// Computes where one line crosses many spheres, with a sphere in each lane, and where it crosses a brick, with an axis
// in each lane. Compiled once for each instruction set, by lanes.cpp.
#if defined(CSGCAST_LANE_BALLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_BALLS_INL_H
#undef CSGCAST_LANE_BALLS_INL_H
#else
#define CSGCAST_LANE_BALLS_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "raycast/cells/build/cell_data.h"
#include "raycast/packets/detail/lane_events-inl.h"
#include "raycast/packets/detail/lane_line-inl.h"
#include "raycast/packets/detail/lane_order-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

template <class V>
struct Columns {
  V c[4];
};

/// Loads four numbers from each lane's place in memory. Each place must be 16 bytes aligned.
template <class D>
HWY_INLINE Columns<hh::Vec<D>> columns_of(D d, const double* const* rows) {
#if HWY_TARGET == HWY_SCALAR
  return {{hh::Set(d, rows[0][0]), hh::Set(d, rows[0][1]), hh::Set(d, rows[0][2]), hh::Set(d, rows[0][3])}};
#else
  constexpr std::size_t lanes = hh::MaxLanes(D());
  if constexpr (lanes == 8) {
    const hh::Half<D> half;
    const auto low = columns_of(half, rows);
    const auto high = columns_of(half, rows + 4);
    Columns<hh::Vec<D>> all;
    for (std::size_t i = 0; i < 4; ++i) all.c[i] = hh::Combine(d, high.c[i], low.c[i]);
    return all;
  } else if constexpr (lanes == 4) {
    const auto a = hh::LoadU(d, rows[0]), b = hh::LoadU(d, rows[1]);
    const auto e = hh::LoadU(d, rows[2]), f = hh::LoadU(d, rows[3]);
    const auto low_ab = hh::InterleaveLower(d, a, b), high_ab = hh::InterleaveUpper(d, a, b);
    const auto low_ef = hh::InterleaveLower(d, e, f), high_ef = hh::InterleaveUpper(d, e, f);
    return {{hh::ConcatLowerLower(d, low_ef, low_ab), hh::ConcatLowerLower(d, high_ef, high_ab),
             hh::ConcatUpperUpper(d, low_ef, low_ab), hh::ConcatUpperUpper(d, high_ef, high_ab)}};
  } else {
    static_assert(lanes == 2);
    const auto a = hh::LoadU(d, rows[0]), b = hh::LoadU(d, rows[1]);
    const auto e = hh::LoadU(d, rows[0] + 2), f = hh::LoadU(d, rows[1] + 2);
    return {{hh::InterleaveLower(d, a, b), hh::InterleaveUpper(d, a, b), hh::InterleaveLower(d, e, f),
             hh::InterleaveUpper(d, e, f)}};
  }
#endif
}

/// A line, the same in all lanes, as needed for spheres.
struct BallLine {
  using V = hh::Vec<SlotLanes>;
  Triples<V> near, direction;
  V inverse_squared;

  explicit BallLine(const LineLanes<hn::Single<double>>& line)
      : near(in_all_lanes(SlotLanes(), line.near)),
        direction(in_all_lanes(SlotLanes(), line.direction)),
        inverse_squared(hh::Set(SlotLanes(), line.inverse_squared)) {}
};

/// The crossings of a line with the spheres of some slots.
struct BallRow {
  using V = hh::Vec<SlotLanes>;
  using M = hh::Mask<SlotLanes>;
  V first, second;
  M is_open;
  M outside_is_positive;
};

/// `slots` has one slot for each lane.
HWY_INLINE BallRow ball_row(const BallLine& line, const Slot* const* slots) {
  const SlotLanes d;
  const double* rows[8];
  const double* more[8];
  for (std::size_t i = 0; i < hh::Lanes(d); ++i) {
    rows[i] = slots[i]->c.data();
    more[i] = slots[i]->c.data() + 2;  // its last two numbers are loaded together with two known ones
  }
  const auto k = columns_of(d, rows);
  const auto m = columns_of(d, more);
  const auto crossings = sphere_crossings(d, line.near - Triples<BallRow::V>{k.c[0], k.c[1], k.c[2]}, line.direction,
                                          line.inverse_squared, k.c[3]);
  return {crossings.first, crossings.second, hh::Le(hh::Abs(crossings.discriminant), m.c[2]),
          hh::Gt(m.c[3], hh::Zero(d))};
}

/// The stretch of a line that is in a brick.
struct BrickCrossings {
  double enters, leaves;
  unsigned enters_by, leaves_by;  ///< one bit for each axis whose planes the line may enter or leave by
};

/// Events at least `apart` from each other are certain to be in order.
HWY_INLINE BrickCrossings brick_crossings(const LineLanes<hn::Single<double>>& line, const Brick& brick, double apart) {
  const SlotLanes d;
  using V = hh::Vec<SlotLanes>;
  constexpr std::size_t lanes = hh::MaxLanes(SlotLanes());
  V near[4 / lanes], far[4 / lanes];
  V last_near = hh::Neg(hh::Inf(d)), first_far = hh::Inf(d);
  for (std::size_t i = 0; i < 4; i += lanes) {
    const V inverse = hh::LoadU(d, line.axis_inverse + i), offset = hh::LoadU(d, line.axis_offset + i);
    const V a = hh::MulSub(hh::Load(d, brick.lower + i), inverse, offset);
    const V b = hh::MulSub(hh::Load(d, brick.upper + i), inverse, offset);
    near[i / lanes] = hh::Min(a, b);
    far[i / lanes] = hh::Max(a, b);
    last_near = hh::Max(last_near, near[i / lanes]);
    first_far = hh::Min(first_far, far[i / lanes]);
  }
  last_near = hh::MaxOfLanes(d, last_near);
  first_far = hh::MinOfLanes(d, first_far);
  const V least_enters = hh::Sub(last_near, hh::Set(d, apart)), most_leaves = hh::Add(first_far, hh::Set(d, apart));
  BrickCrossings crossings{hh::GetLane(last_near), hh::GetLane(first_far), 0, 0};
  for (std::size_t i = 0; i < 4; i += lanes) {
    crossings.enters_by |= lane_bits(d, hh::Ge(near[i / lanes], least_enters)) << i;
    crossings.leaves_by |= lane_bits(d, hh::Le(far[i / lanes], most_leaves)) << i;
  }
  return crossings;
}

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
