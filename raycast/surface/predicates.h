// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <memory>
#include <optional>

#include "raycast/line/crossing.h"
#include "raycast/line/line_frame.h"
#include "raycast/line/ray.h"
#include "raycast/surface/surface.h"

// The three predicates that every structural decision passes through: the sign of a surface at a point, which crossings
// exist, and the order of two crossings. Each is what exact arithmetic says: floating point decides where its own error
// bound allows it, exact numbers elsewhere. The bounds are derived in docs/accuracy.md.

namespace csgcast {

/// What exact arithmetic found out about one line, to be asked for again.
class LineMemory {
 public:
  LineMemory();
  ~LineMemory();
  LineMemory(LineMemory&&) noexcept;

  /// The line is another one.
  void forget();

  struct State;
  State& state() const { return *state_; }

 private:
  std::unique_ptr<State> state_;
};

/// The line of one ray, as the predicates see it.
struct Line {
  Line(const Ray& r, const Frame& frame, SurfaceId from = {}, Sense side = Sense::positive)
      : ray(r), in_frame(r, frame), departure(from), departure_side(side) {}

  Ray ray;
  LineFrame in_frame;
  SurfaceId departure;  ///< the surface that the ray starts on, exactly, by definition; or none
  Sense departure_side = Sense::positive;
  LineMemory* memory = nullptr;  ///< where the exact stage keeps what it finds; null: nowhere
};

/// Decisions that double left open: those that twofold arithmetic took, and the rest, by kind, that took exact numbers.
struct ExactCalls {
  std::uint64_t twofold = 0;
  std::uint64_t existence = 0;
  std::uint64_t order = 0;
  std::uint64_t rounding = 0;  ///< of a reported t; decides no structure
  std::uint64_t structural() const { return existence + order; }
  std::uint64_t beyond_double() const { return twofold + structural(); }
};

/// What one line meets of one surface f: its crossings in ascending order and the sign of f before the first.
///
/// A double root is no crossing. Where f vanishes along the whole line (a ray in a plane, a generator of a quadric)
/// there is no crossing and the line is on the positive side. Of the surface that a ray departs from only what comes
/// after the start is told: no crossing at t = 0. Of a local surface (surface.h) only crossings in the frame's unit
/// cube are told for certain: one that lies outside may be missing.
struct LineCrossings {
  std::array<double, 2> tau{};  ///< in the line's frame (line_frame.h)
  double error = 0;             ///< bound on |tau - exact tau|, of both
  std::uint8_t count = 0;
  bool positive_before = true;

  /// The sign of f after the first n crossings.
  bool positive_after(unsigned n) const { return positive_before != ((n & 1u) != 0); }
};

/// -1, 0 or 1: the sign of f(p).
int sign_at(const Surface& surface, Point p);

/// A crossing with what the predicates need to know of it.
struct CrossingView {
  SurfaceId id;
  const Surface* surface;
  const LineCrossings* found;
  std::uint8_t root;

  double tau() const { return found->tau[root]; }
};

/// The predicates of crossings. A caster works with one such table; every caller is the same for all.
struct Predicates {
  /// Which crossings exist. `id` is the surface's own, to know a departure by.
  LineCrossings (*crossings)(const Line& line, SurfaceId id, const Surface& surface, ExactCalls& calls);
  /// Which of two crossings of one line comes first.
  std::weak_ordering (*order)(const Line& line, const CrossingView& a, const CrossingView& b, ExactCalls& calls);
  /// Whether a crossing comes before, at or after t (infinities allowed).
  std::weak_ordering (*order_with)(const Line& line, const CrossingView& a, double t, ExactCalls& calls);
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
