// SPDX-License-Identifier: MIT
#pragma once

#include <compare>

#include "raycast/surface/line_crossings.h"

// Every structural decision passes through three predicates: the sign of a surface at a point, which crossings exist,
// and the order of two crossings. The answers are those of exact arithmetic. Floating point decides where its own error
// bound allows it, and exact numbers decide elsewhere. The bounds are derived in docs/accuracy.md.

namespace csgcast {

/// The sign of f(p): -1, 0 or 1.
int sign_at(const Surface& surface, Point p);

/// The table of predicates of crossings that a caster works with. All callers use every table alike.
struct Predicates {
  /// Finds the crossings that exist. `id` is the surface's own id; by it a departure is recognised.
  LineCrossings (*crossings)(const Line& line, SurfaceId id, const Surface& surface, ExactCalls& calls);
  /// Orders two crossings of one line.
  std::weak_ordering (*order)(const Line& line, const CrossingView& a, const CrossingView& b, ExactCalls& calls);
  /// Orders a crossing and t, which may be infinite.
  std::weak_ordering (*order_with)(const Line& line, const CrossingView& a, double t, ExactCalls& calls);
  /// Whether a crossing comes before, at or after a finite tau of the line's frame.
  std::weak_ordering (*order_in_frame)(const Line& line, const CrossingView& a, double tau, ExactCalls& calls);
  /// The t to report.
  double (*reported_t)(const Line& line, const CrossingView& crossing, ExactCalls& calls);
};

/// The answers of exact arithmetic, at nearly the price of floating point. Reported t is the nearest double. This is
/// the default.
const Predicates& certified_predicates();
/// The same answers from exact arithmetic alone. It is slow, and serves for comparison.
const Predicates& exact_predicates();
/// Plain floating point: the same formulas without their bounds. The benchmark of the cost of certification uses it.
const Predicates& uncertified_predicates();

}  // namespace csgcast
