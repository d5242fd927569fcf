// SPDX-License-Identifier: MIT
#pragma once

#include <compare>

#include "raycast/surface/line_crossings.h"

// The three predicates that every structural decision passes through: the sign of a surface at a point, which crossings
// exist, and the order of two crossings. Each is what exact arithmetic says: floating point decides where its own error
// bound allows it, exact numbers elsewhere. The bounds are derived in docs/accuracy.md.

namespace csgcast {

/// -1, 0 or 1: the sign of f(p).
int sign_at(const Surface& surface, Point p);

/// The predicates of crossings. A caster works with one such table; every caller is the same for all.
struct Predicates {
  /// Which crossings exist. `id` is the surface's own, to know a departure by.
  LineCrossings (*crossings)(const Line& line, SurfaceId id, const Surface& surface, ExactCalls& calls);
  /// Which of two crossings of one line comes first.
  std::weak_ordering (*order)(const Line& line, const CrossingView& a, const CrossingView& b, ExactCalls& calls);
  /// Whether a crossing comes before, at or after t (infinities allowed).
  std::weak_ordering (*order_with)(const Line& line, const CrossingView& a, double t, ExactCalls& calls);
  /// Whether a crossing comes before, at or after a finite tau of the line's frame.
  std::weak_ordering (*order_in_frame)(const Line& line, const CrossingView& a, double tau, ExactCalls& calls);
  /// The t to report.
  double (*reported_t)(const Line& line, const CrossingView& crossing, ExactCalls& calls);
};

/// What exact arithmetic says, at nearly the price of floating point; t is the nearest double. The default.
const Predicates& certified_predicates();
/// The same answers from exact arithmetic alone: slow, to compare with.
const Predicates& exact_predicates();
/// Floating point as it comes, by the same formulas without their bounds: what certification costs is measured against
/// it.
const Predicates& uncertified_predicates();

}  // namespace csgcast
