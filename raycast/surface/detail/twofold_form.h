// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "csg/base/length.h"
#include "csg/base/precondition.h"
#include "csg/exact/quadric_form.h"
#include "raycast/line/twofold_root.h"
#include "raycast/surface/detail/bounded.h"
#include "raycast/surface/line_crossings.h"

// The second rung of the ladder is twofold arithmetic. This is what kinds with a form of the second degree share for
// it. The bounds are derived in docs/accuracy.md.

namespace csgcast::detail {

constexpr double uu = unit_roundoff * unit_roundoff;
constexpr double underflow = 0x1p-1000;  // far above what low parts lose to it

struct TwofoldBounded {
  Twofold value;
  double error;

  bool is_certain() const { return std::fabs(value.high) > 2 * error; }  // the low part is below u of the high one
  bool is_positive() const { return value.high > 0; }
};

using TwofoldVector = std::array<Twofold, 3>;

/// True if this rung decides nothing. After a departure the form is a different one, and numbers out of their range are
/// useless.
inline bool is_beyond_twofold(const Line& line, SurfaceId id, const Surface& surface) {
  return id == line.departure || !surface.in_range || !line.in_frame.in_range;
}

inline double longest(const TwofoldVector& q) {
  return std::fmax(std::fabs(q[0].high), std::fmax(std::fabs(q[1].high), std::fabs(q[2].high)));
}

inline Twofold coefficient(const Surface& surface, std::size_t term) {
  return {surface.local[term], surface.local_low[term]};
}

inline Twofold dot(const TwofoldVector& a, const TwofoldVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Twofold dot(const TwofoldVector& a, Vector b) { return a[0] * b.x + a[1] * b.y + a[2] * b.z; }

inline TwofoldVector first_degree(const Surface& surface) {
  return {coefficient(surface, QuadricForm::x), coefficient(surface, QuadricForm::y),
          coefficient(surface, QuadricForm::z)};
}

/// `near` relative to the surface's center. It is off by near_low_error and a relative 3 u².
inline TwofoldVector start_of(const LineFrame& line, const Surface& surface) {
  TwofoldVector start;
  for (std::size_t axis = 0; axis < 3; ++axis)
    start[axis] = Twofold{line.near[axis], line.near_low[axis]} + two_sum(-surface.center[axis], 0);
  return start;
}

/// Computes a / b. The result is off by a relative 16 u² and by the errors of its operands. Precondition: b is certain.
inline TwofoldBounded quotient(const TwofoldBounded& a, const TwofoldBounded& b) {
  CSGCAST_PRECONDITION(b.is_certain());
  const double first = a.value.high / b.value.high;
  const Twofold left = a.value + -(b.value * first);
  const Twofold value = fast_two_sum(first, left.high / b.value.high);
  const double size = std::fabs(value.high);
  return {value, (4 * (a.error + size * b.error) / std::fabs(b.value.high) + 16 * uu * size) * rounding_of_bounds};
}

inline void report(LineCrossings& found, unsigned root, const TwofoldRoot& tau) {
  found.few[root] = tau.tau.high;
  found.error = std::fmax(found.error, tau.error + unit_roundoff * std::fabs(tau.tau.high));
}

}  // namespace csgcast::detail
