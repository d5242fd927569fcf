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

// Every structural decision passes through three predicates: the sign of a surface at a point, which crossings exist,
// and the order of two crossings. Each answers what exact arithmetic says. Floating point decides where its own error
// bound allows it, exact numbers decide elsewhere. docs/accuracy.md derives the bounds.

namespace csgcast {

/// Keeps what exact arithmetic found out about one line, so that it is computed once.
class LineMemory {
 public:
  LineMemory();
  ~LineMemory();
  LineMemory(LineMemory&&) noexcept;

  /// Forgets everything; called when the line becomes another one.
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
  SurfaceId departure;  ///< the surface that the ray starts on, by definition exactly; not valid if there is none
  Sense departure_side = Sense::positive;
  LineMemory* memory = nullptr;  ///< where the exact stage keeps what it finds; null: it keeps nothing
};

/// Counts of the decisions that double left open.
struct ExactCalls {
  std::uint64_t twofold = 0;    ///< taken by twofold arithmetic; all others took exact numbers
  std::uint64_t existence = 0;  ///< which crossings exist
  std::uint64_t order = 0;      ///< which of two crossings comes first
  std::uint64_t rounding = 0;   ///< which double is nearest to a reported t; decides no structure
  std::uint64_t structural() const { return existence + order; }
  std::uint64_t beyond_double() const { return twofold + structural(); }
};

/// The crossings of one line with one surface f, in ascending order, and the sign of f before the first.
///
/// A double root is no crossing. If f vanishes along the whole line (a ray in a plane, a generator of a quadric) there
/// is no crossing, and the line is on the positive side. With the surface that a ray departs from only crossings after
/// the start are listed, none at t = 0. With a local surface (surface.h) only crossings in the frame's unit cube are
/// certain to be listed: one that lies outside may be missing.
struct LineCrossings {
  std::array<double, 2> tau{};  ///< in the line's frame (line_frame.h)
  double error = 0;             ///< bound on |tau - exact tau|, for both
  std::uint8_t count = 0;
  bool positive_before = true;

  /// The sign of f after the first n crossings.
  bool positive_after(unsigned n) const { return positive_before != ((n & 1u) != 0); }
};

/// The sign of f(p), exactly: -1, 0 or 1.
int sign_at(const Surface& surface, Point p);

/// A crossing with what the predicates need to know about it.
struct CrossingView {
  SurfaceId id;
  const Surface* surface;
  const LineCrossings* found;
  std::uint8_t root;

  double tau() const { return found->tau[root]; }
};

/// The predicates about crossings, as a table of functions. A caster works with one such table, so all that calls it is
/// the same whichever predicates are chosen.
struct Predicates {
  /// Which crossings exist. `id` is the surface's own; it tells whether the line departs from this surface.
  LineCrossings (*crossings)(const Line& line, SurfaceId id, const Surface& surface, ExactCalls& calls);
  /// Which of two crossings of one line comes first.
  std::weak_ordering (*order)(const Line& line, const CrossingView& a, const CrossingView& b, ExactCalls& calls);
  /// Whether a crossing comes before, at or after t (infinities allowed).
  std::weak_ordering (*order_with)(const Line& line, const CrossingView& a, double t, ExactCalls& calls);
  /// The t to report.
  double (*reported_t)(const Line& line, const CrossingView& crossing, ExactCalls& calls);
};

/// The answers of exact arithmetic, at nearly the price of floating point; a reported t is the nearest double. The
/// default.
const Predicates& certified_predicates();
/// The same answers from exact arithmetic alone. They are slow, and serve for comparison.
const Predicates& exact_predicates();
/// The answers of plain floating point, by the same formulas without their bounds. They may be wrong, and serve to
/// measure what certification costs.
const Predicates& uncertified_predicates();

}  // namespace csgcast
