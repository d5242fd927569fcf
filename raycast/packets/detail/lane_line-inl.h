// SPDX-License-Identifier: MIT
// The lines of many rays in the frame, with a ray in each lane. The operations are those of LineFrame (line_frame.h) in
// the same order, so the numbers are the same to the last bit. Compiled once for each instruction set, by lanes.cpp.
#if defined(CSGCAST_LANE_LINE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_LINE_INL_H
#undef CSGCAST_LANE_LINE_INL_H
#else
#define CSGCAST_LANE_LINE_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <limits>

#include "raycast/cells/build/cell_data.h"
#include "raycast/line/frame.h"
#include "raycast/packets/detail/ray_pointers.h"
#include "raycast/simd/vector_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {
namespace hn = csgcast::HWY_NAMESPACE::ops;
using csgcast::HWY_NAMESPACE::biased_exponent;
using csgcast::HWY_NAMESPACE::BitsOf;
using csgcast::HWY_NAMESPACE::choose;
using csgcast::HWY_NAMESPACE::in_all_lanes;
using csgcast::HWY_NAMESPACE::load_lanes;
using csgcast::HWY_NAMESPACE::normalised_lanes;
using csgcast::HWY_NAMESPACE::power_of_biased;
using csgcast::HWY_NAMESPACE::store_lanes;
using csgcast::HWY_NAMESPACE::Triples;

/// One bit for each lane, of which there are at most eight.
template <class D>
HWY_INLINE unsigned lane_bits(D d, hn::Mask<D> mask) {
  std::uint8_t bits[8];
  hn::StoreMaskBits(d, mask, bits);
  return bits[0];
}

template <class V>
struct Exact {
  V high, low;
};

/// Knuth's exact sum.
template <class V>
HWY_INLINE Exact<V> two_sum(V a, V b) {
  const V sum = hn::Add(a, b);
  const V b_part = hn::Sub(sum, a);
  const V a_part = hn::Sub(sum, b_part);
  return {sum, hn::Add(hn::Sub(a, a_part), hn::Sub(b, b_part))};
}

template <class V>
HWY_INLINE Exact<V> fast_two_sum(V a, V b) {
  const V sum = hn::Add(a, b);
  return {sum, hn::Sub(b, hn::Sub(sum, a))};
}

/// The exact product: fused where the machine can, else Dekker's.
template <class D>
HWY_INLINE Exact<hn::Vec<D>> two_product(D d, hn::Vec<D> a, hn::Vec<D> b) {
  using V = hn::Vec<D>;
  const V product = hn::Mul(a, b);
#if HWY_NATIVE_FMA
  return {product, hn::MulSub(a, b, product)};
#else
  const V splitter = hn::Set(d, 0x1p27 + 1);
  const V wide_a = hn::Mul(splitter, a);
  const V wide_b = hn::Mul(splitter, b);
  const V high_a = hn::Sub(wide_a, hn::Sub(wide_a, a));
  const V high_b = hn::Sub(wide_b, hn::Sub(wide_b, b));
  const V low_a = hn::Sub(a, high_a);
  const V low_b = hn::Sub(b, high_b);
  const V first = hn::Sub(hn::Mul(high_a, high_b), product);
  return {product,
          hn::Add(hn::Add(hn::Add(first, hn::Mul(high_a, low_b)), hn::Mul(low_a, high_b)), hn::Mul(low_a, low_b))};
#endif
}

/// Lanes without certificates have no bounds, flag nothing, and resolve ties arbitrarily. They exist for the benchmark
/// of the cost of certification.
#ifdef CSGCAST_UNCERTIFIED_LANES
constexpr bool certified = false;
#else
constexpr bool certified = true;
#endif

/// Computes 2^n, which must be a normal double.
inline double power_of_two(int n) { return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + n) << 52); }

template <class D>
struct LineLanes {
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  Triples<V> near, direction;
  Triples<V> low;  ///< the rounding error of `near`, if it is wanted
  bool wants_low;
  V direction_squared, inverse_squared;  ///< set only if the scene has quadrics
  V shift, unit;
  V low_error;   ///< bound on the error of each coordinate of `near` + `low`
  V near_error;  ///< bound on the error of each coordinate of `near`

  Triples<V> walk_near, walk_direction;  ///< in the axes of the cells
  // For single rays bricks load the fourth number as well: it is like an axis along which bricks are infinite.
  V axis_inverse[4];     ///< inverse of walk_direction; huge where that is zero
  V axis_offset[4];      ///< walk_near times axis_inverse
  V across_inverse[3];   ///< 1 / (direction_squared less the square along the axis); 0 for rays nearly along the axis
  bool any_is_steep[3];  ///< true if some lane is nearly along the axis
  V across_size[3];      ///< in that case: the length across the axis, for these rays; else -1
  bool any_is_loose;     ///< true if some lane is not certain of all planes square to some axis
  V guard[3];            ///< in that case: a plane nearer than this is left to the caster; below 0: never
  V start, end;          ///< tau
  bool ends;             ///< true if some lane has an end
  V end_error;           ///< four times the error bound of the end
  V slack;               ///< four times the error bound of an event with a plane square to an axis
  M valid;

  LineLanes() {
    axis_inverse[3] = hn::Set(D(), 1.0);
    axis_offset[3] = hn::Zero(D());
  }
};

/// Sets `near` to the point nearest to the frame's center, or to the start if that is near.
template <class D>
HWY_INLINE void set_near(D d, const Frame& frame, const Triples<hn::Vec<D>>& o, LineLanes<D>& line) {
  using V = hn::Vec<D>;
  const V to_frame = hn::Set(d, power_of_two(-frame.exponent));
  const Triples<V> back{hn::Set(d, -frame.center.x), hn::Set(d, -frame.center.y), hn::Set(d, -frame.center.z)};
  const Triples<V> from_center = o + back;
  line.near = {hn::Mul(from_center.x, to_frame), hn::Mul(from_center.y, to_frame), hn::Mul(from_center.z, to_frame)};
  line.shift = hn::Zero(d);
  const V size = longest(line.near);
  const auto is_far = hn::Gt(size, hn::Set(d, 2.0));
  const bool some_are_far = !hn::AllFalse(d, is_far);
  if (line.wants_low || some_are_far) {
    line.low = {hn::Mul(two_sum(o.x, back.x).low, to_frame), hn::Mul(two_sum(o.y, back.y).low, to_frame),
                hn::Mul(two_sum(o.z, back.z).low, to_frame)};
  }
  if (some_are_far) {
    const V inverse = hn::Div(hn::Set(d, 1.0), dot(line.direction, line.direction));
    line.shift = hn::IfThenElseZero(is_far, hn::Mul(hn::Neg(dot(line.near, line.direction)), inverse));
    const auto move = [&](V along, V& near, V& low) {
      const auto step = two_product(d, line.shift, along);
      const auto sum = two_sum(near, step.high);
      const auto at = fast_two_sum(sum.high, hn::Add(sum.low, hn::Add(step.low, low)));
      near = at.high;
      low = at.low;
    };
    move(line.direction.x, line.near.x, line.low.x);
    move(line.direction.y, line.near.y, line.low.y);
    move(line.direction.z, line.near.z, line.low.z);
  }
  const V reach = hn::Add(size, hn::Mul(hn::Set(d, 2.0), hn::Abs(line.shift)));
  line.low_error = hn::Add(hn::Mul(hn::Set(d, 0x8p-106), reach), hn::Set(d, 0x1p-1000));
  line.near_error = hn::Add(hn::Mul(hn::Set(d, 0x1p-53), longest(line.near)), line.low_error);
  // From farther away, the error of `near` is larger than its own rounding, which is all that the constants allow for.
  line.valid = hn::And(line.valid, hn::Lt(line.low_error, hn::Set(d, 0x1p-55)));
}

/// The lanes in which a component of the direction is not zero, but so small beside the longest that its products may
/// underflow.
template <class D>
HWY_INLINE hn::Mask<D> has_tiny_part(D d, const Triples<hn::Vec<D>>& v, hn::Vec<D> length) {
  using V = hn::Vec<D>;
  const V least = hn::Mul(length, hn::Set(d, 0x1p-332));
  const V smallest = hn::Min(hn::Min(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
  auto tiny = hn::Lt(smallest, least);
  if (hn::AllFalse(d, tiny)) return tiny;
  const auto is_tiny = [&](V part) { return hn::And(hn::Lt(hn::Abs(part), least), hn::Ne(part, hn::Zero(d))); };
  return hn::Or(is_tiny(v.x), hn::Or(is_tiny(v.y), is_tiny(v.z)));
}

/// A vector in the axes of the cells.
template <class D>
HWY_INLINE Triples<hn::Vec<D>> turned(D d, const std::array<Vector, 3>& axes, const Triples<hn::Vec<D>>& v) {
  return {dot(in_all_lanes(d, axes[0]), v), dot(in_all_lanes(d, axes[1]), v), dot(in_all_lanes(d, axes[2]), v)};
}

/// A line relative to the middle of the solid's box, along the box's sides.
template <class D>
struct LineFromMiddle {
  hn::Vec<D> at[3], along[3];
  hn::Vec<D> reach[3];  ///< half the box's sides, plus the error of `at`
  hn::Vec<D> least;     ///< a further error bound of cross products
};

template <class D>
HWY_INLINE LineFromMiddle<D> line_from_middle(D d, const CellData& cells, const Triples<hn::Vec<D>>& origin,
                                              const Triples<hn::Vec<D>>& direction) {
  using V = hn::Vec<D>;
  const V u8 = hn::Set(d, 8 * 0x1p-53);
  const Triples<V> at = origin - in_all_lanes(d, cells.middle - Point{});
  const auto reach = [&](V from, double half) { return hn::MulAdd(u8, hn::Abs(from), hn::Set(d, half)); };
  return {{at.x, at.y, at.z},
          {direction.x, direction.y, direction.z},
          {reach(at.x, cells.half_size.x), reach(at.y, cells.half_size.y), reach(at.z, cells.half_size.z)},
          hn::Set(d, 0x1p-1000)};
}

/// The same for turned cells.
template <class D>
HWY_INLINE LineFromMiddle<D> line_from_turned_middle(D d, const Frame& frame, const CellData& cells,
                                                     const Triples<hn::Vec<D>>& origin,
                                                     const Triples<hn::Vec<D>>& direction) {
  using V = hn::Vec<D>;
  const Triples<V> from_center = origin - in_all_lanes(d, frame.center - Point{});
  const Triples<V> at = turned(d, cells.axes, from_center) - in_all_lanes(d, cells.middle - Point{});
  const Triples<V> along = turned(d, cells.axes, direction);
  const Vector& half = cells.half_size;
  const V size = hn::Add(longest(from_center), hn::Set(d, power_of_two(frame.exponent)));
  return {{at.x, at.y, at.z},
          {along.x, along.y, along.z},
          {hn::Set(d, half.x), hn::Set(d, half.y), hn::Set(d, half.z)},
          hn::Mul(hn::Mul(hn::Set(d, 0x1p-44), size), longest(direction))};
}

/// The lanes whose lines certainly pass by the solid's box. A line and a box are apart if they are apart in the view
/// along an axis. There the line's distance from the box's middle, times the direction's length, is a cross product.
/// Its terms have a relative error of 3 u, which is added to the box's size. What underflows is far less than `least`,
/// for sizes and directions in range, 2^-400 and more. For a turned line the total error is less than 150 u times its
/// length, times its distance plus the box's size.
template <class D>
HWY_INLINE hn::Mask<D> passes_by(D d, const Frame& frame, const CellData& cells, const Triples<hn::Vec<D>>& origin,
                                 const Triples<hn::Vec<D>>& direction) {
  using V = hn::Vec<D>;
  const LineFromMiddle<D> line = cells.is_turned ? line_from_turned_middle(d, frame, cells, origin, direction)
                                                 : line_from_middle(d, cells, origin, direction);
  const V size[3] = {hn::Abs(line.along[0]), hn::Abs(line.along[1]), hn::Abs(line.along[2])};
  auto result = hn::MaskFromVec(hn::Zero(d));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t i = (axis + 1) % 3;
    const std::size_t j = (axis + 2) % 3;
    const V distance = hn::Abs(hn::Sub(hn::Mul(line.at[i], line.along[j]), hn::Mul(line.at[j], line.along[i])));
    const V most = hn::MulAdd(line.reach[i], size[j], hn::MulAdd(line.reach[j], size[i], line.least));
    result = hn::Or(result, hn::Gt(distance, most));
  }
  return result;
}

/// The line in its frame, as LineFrame makes it.
template <class D>
HWY_INLINE void set_line(D d, const Frame& frame, const CellData& cells, const Triples<hn::Vec<D>>& origin,
                         const Triples<hn::Vec<D>>& v, LineLanes<D>& line) {
  using V = hn::Vec<D>;
  const BitsOf<D> bits;
  const V length = longest(v);
  const auto exponent = biased_exponent(d, length);
  const V scale = power_of_biased(d, hn::Sub(hn::Set(bits, 2046u), exponent));
  line.direction = {hn::Mul(v.x, scale), hn::Mul(v.y, scale), hn::Mul(v.z, scale)};
  // With no part that is tiny beside the longest all are normal, and scaled exactly.
  line.valid = hn::And(hn::Gt(length, hn::Set(d, 0x1p-600)), hn::Lt(length, hn::Set(d, 0x1p600)));
  line.valid = hn::AndNot(has_tiny_part(d, v, length), line.valid);
  line.unit = power_of_biased(d, hn::Sub(hn::Set(bits, static_cast<std::uint64_t>(2046 + frame.exponent)), exponent));
  if (cells.has_quadrics) {
    line.direction_squared = dot(line.direction, line.direction);
    line.inverse_squared = hn::Div(hn::Set(d, 1.0), line.direction_squared);
  }
  set_near(d, frame, origin, line);
}

/// The tau at which the line passes a place on an axis of the cells.
template <class D>
HWY_INLINE hn::Vec<D> tau_at(D d, const LineLanes<D>& line, std::size_t axis, double place) {
  return hn::MulSub(hn::Set(d, place), line.axis_inverse[axis], line.axis_offset[axis]);
}

/// Cuts the stretches of lines to a box along the axes of the cells.
template <class D>
HWY_INLINE void clip_to_box(D d, const LineLanes<D>& line, const CellBox& box, hn::Vec<D>& from, hn::Vec<D>& to) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    const auto low = tau_at(d, line, axis, box.lower[axis]);
    const auto high = tau_at(d, line, axis, box.upper[axis]);
    from = hn::Max(from, hn::Min(low, high));
    to = hn::Min(to, hn::Max(low, high));
  }
}

/// The axes along which a lane's line falls, one bit each.
template <class D>
HWY_INLINE unsigned falling_axes(D d, const LineLanes<D>& line, std::size_t lane) {
  unsigned falls = 0;
  for (unsigned axis = 0; axis < 3; ++axis) {
    HWY_ALIGN double values[16];
    hn::Store(line.axis_inverse[axis], d, values);
    falls |= static_cast<unsigned>(values[lane] < 0) << axis;
  }
  return falls;
}

/// A dot product with fewer roundings than dot(). It is used only where bounds certify the result, and other formulas
/// compute what is reported.
template <class V>
HWY_INLINE V fused_dot(const Triples<V>& a, const Triples<V>& b) {
  return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}

/// Computes 1 / v. If v is zero, the result is so large that its product with anything but zero is out of reach.
template <class D>
HWY_INLINE hn::Vec<D> inverse_of(D d, hn::Vec<D> v) {
  const hn::Vec<D> least = hn::Set(d, 1e-250);
  return hn::Div(hn::Set(d, 1.0), hn::IfThenElse(hn::Lt(hn::Abs(v), least), least, v));
}

/// This is more than four times the error of coordinates on the way, and so of the borders of cells.
constexpr double least_slack = 0x1p-46;

/// Sets how certain events with planes square to an axis are.
template <class D>
HWY_INLINE void set_slack(D d, const AxisBounds& bounds, const hn::Vec<D>* along, LineLanes<D>& line) {
  using V = hn::Vec<D>;
  const V least = hn::Set(d, least_slack);
  const V factor = hn::Set(d, bounds.slack);
  const V greatest = hn::Set(d, greatest_slack);
  const V most = hn::Mul(factor, longest(Triples<V>{line.axis_inverse[0], line.axis_inverse[1], line.axis_inverse[2]}));
  line.slack = hn::Max(least, most);
  line.any_is_loose = !hn::AllFalse(d, hn::Gt(most, greatest));
  if (!line.any_is_loose) return;
  line.slack = least;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const V off = hn::Mul(factor, hn::Abs(line.axis_inverse[axis]));
    const auto is_loose = hn::Gt(off, greatest);
    line.slack = hn::Max(line.slack, hn::IfThenZeroElse(is_loose, off));
    const V guard = hn::Max(hn::Set(d, bounds.guard), hn::Mul(hn::Set(d, 8.5), hn::Abs(along[axis])));
    line.guard[axis] = hn::IfThenElse(is_loose, guard, hn::Set(d, -1.0));
  }
}

/// The tau at which lines without an end stop. It is beyond every crossing, because a component of a direction is zero
/// or at least 1e-100. It is before the places at which lanes let a line cross a plane that it is parallel to
/// (inverse_of).
constexpr double farthest = 1e200;

/// Computes what walks and tests need in addition.
template <class D>
HWY_INLINE void prepare_walk(D d, const CellData& cells, const RayPointers& rays, std::size_t first, std::size_t count,
                             LineLanes<D>& line) {
  using V = hn::Vec<D>;
  const V zero = hn::Zero(d);
  const AxisBounds& bounds = cells.axis_bounds;
  line.walk_near = line.near;
  line.walk_direction = line.direction;
  if (cells.is_turned) {
    line.walk_near = turned(d, cells.axes, line.near);
    line.walk_direction = turned(d, cells.axes, line.direction);
  }
  const V along[3] = {line.walk_direction.x, line.walk_direction.y, line.walk_direction.z};
  // The sign is taken from the inverse, so that a number that is practically zero counts as positive everywhere.
  const V near[3] = {line.walk_near.x, line.walk_near.y, line.walk_near.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    line.axis_inverse[axis] = inverse_of(d, along[axis]);
    line.axis_offset[axis] = hn::Mul(near[axis], line.axis_inverse[axis]);
  }
  line.slack = hn::Set(d, certified ? least_slack : 0.0);
  line.any_is_loose = false;
  if (certified && cells.has_axis_planes) set_slack(d, bounds, along, line);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!cells.has_cylinders[axis]) continue;
    const V i = along[(axis + 1) % 3];
    const V j = along[(axis + 2) % 3];
    const V across = hn::MulAdd(i, i, hn::Mul(j, j));
    const auto is_steep = hn::Lt(across, hn::Set(d, bounds.steep));
    line.across_inverse[axis] = hn::Div(hn::Set(d, 1.0), across);
    line.any_is_steep[axis] = !hn::AllFalse(d, is_steep);
    if (!line.any_is_steep[axis]) continue;
    line.across_inverse[axis] = hn::IfThenZeroElse(is_steep, line.across_inverse[axis]);
    line.across_size[axis] = hn::IfThenElse(is_steep, hn::Sqrt(across), hn::Set(d, -1.0));
  }
  line.start = rays.whole_line ? hn::Set(d, -farthest) : hn::Neg(line.shift);
  line.end = hn::Set(d, farthest);
  line.end_error = zero;
  line.ends = rays.end != nullptr;
  if (rays.end != nullptr) {
    const V end = load_lanes(d, rays.end + first, count);
    line.end = hn::Min(hn::Sub(hn::Div(end, line.unit), line.shift), hn::Set(d, farthest));
    const auto is_finite = hn::Lt(line.end, hn::Set(d, farthest));
    line.end_error = hn::IfThenElseZero(is_finite, hn::Mul(hn::Set(d, 8 * 0x1p-53), hn::Abs(line.end)));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
