// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>

#include "raycast/hit.h"
#include "raycast/ray.h"
#include "raycast/surface.h"

// The three predicates that every structural decision passes through: the sign of a surface at a point, which crossings
// exist, and the order of two crossings. Planes, and signs at points, are decided exactly. The roots of quadrics are
// plain double, and what the double says is taken for exact when they are compared with others, so the order is a total
// one.

namespace csgcast {

/// The line of one ray, as the predicates see it.
struct Line {
  Ray ray;
  SurfaceId departure;  ///< the surface that the ray starts on, exactly, by definition; or none
  Sense departure_side = Sense::positive;
  std::uint64_t exact_calls = 0;  ///< decisions that needed exact arithmetic
};

/// What one line meets of one surface f: its crossings in ascending order and the sign of f before the first.
///
/// A double root is no crossing. Where f vanishes along the whole line (a ray in a plane, a generator of a quadric)
/// there is no crossing and the line is on the positive side. Of the surface that a ray departs from only what comes
/// after the start is told: no crossing at t = 0.
struct LineCrossings {
  std::array<double, 2> t{};
  double error = 0;  ///< bound on |t - exact t| of planes; 0 for quadrics, whose t decide as they are
  std::uint8_t count = 0;
  bool positive_before = true;

  /// The sign of f after the first n crossings.
  bool positive_after(unsigned n) const { return positive_before != ((n & 1u) != 0); }
};

/// -1, 0 or 1: the sign of f(p), exact.
int sign_at(const Surface& surface, Point p);

/// Which crossings exist. `id` is the surface's own, to know a departure by.
LineCrossings crossings(Line& line, SurfaceId id, const Surface& surface);

/// A crossing with what the predicates need to know of it.
struct CrossingView {
  SurfaceId id;
  const Surface* surface;
  const LineCrossings* found;
  std::uint8_t root;

  double t() const { return found->t[root]; }
};

/// Which of two crossings of one line comes first.
std::weak_ordering order(Line& line, const CrossingView& a, const CrossingView& b);

/// Whether a crossing comes before, at or after t (infinities allowed).
std::weak_ordering order(Line& line, const CrossingView& a, double t);

}  // namespace csgcast
