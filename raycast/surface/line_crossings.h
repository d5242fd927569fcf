// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "raycast/line/crossing.h"
#include "raycast/line/line_frame.h"
#include "raycast/line/ray.h"
#include "raycast/surface/surface.h"

namespace csgcast {

/// Keeps what was found out about one line: exact numbers, so that they are computed only once, and crossings that do
/// not fit into LineCrossings.
class LineMemory {
 public:
  LineMemory();
  ~LineMemory();
  LineMemory(LineMemory&&) noexcept;

  /// Prepares for another line. What was kept is dropped; the memory stays for the next line.
  void forget();
  /// Returns room for numbers. It is valid until forget().
  std::span<double> room_for(std::size_t count);

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
  SurfaceId departure;  ///< the surface that the ray starts on, exactly, by definition; not valid if there is none
  Sense departure_side = Sense::positive;
  LineMemory* memory = nullptr;  ///< null: nothing is kept, and no surface may have more than two crossings
};

/// The crossings of one line with one surface f, in ascending order, and the sign of f before the first one.
///
/// A root of even multiplicity is no crossing. If f vanishes along the whole line (a ray in a plane, a generator of a
/// quadric), there is no crossing and the line is on the positive side. If the ray departs from the surface, only
/// crossings after the start are listed, none at t = 0. For a local surface (surface.h), only crossings in the frame's
/// unit cube are listed for certain; a crossing outside may be missing.
struct LineCrossings {
  LineCrossings() : few{} {}

  /// The tau of each crossing, in the line's frame (line_frame.h).
  union {
    std::array<double, 2> few;     ///< used for at most two crossings
    std::span<const double> many;  ///< used for more than two; the numbers are in the line's memory
  };
  double error = 0;  ///< bound on |tau - exact tau|, for all crossings
  std::uint8_t count = 0;
  bool positive_before = true;

  double tau(std::size_t root) const { return count <= 2 ? few[root] : many[root]; }
  /// The sign of f after the first n crossings.
  bool positive_after(unsigned n) const { return positive_before != ((n & 1u) != 0); }
};

/// A crossing with all that the predicates need to know about it.
struct CrossingView {
  SurfaceId id;
  const Surface* surface;
  const LineCrossings* found;
  std::uint8_t root;

  double tau() const { return found->tau(root); }
};

/// Counts of the decisions that double left open: those that twofold arithmetic took, and those that took exact
/// numbers, by kind.
struct ExactCalls {
  std::uint64_t twofold = 0;
  std::uint64_t existence = 0;
  std::uint64_t order = 0;
  std::uint64_t rounding = 0;  ///< roundings of a reported t; they decide no structure
  std::uint64_t structural() const { return existence + order; }
  std::uint64_t beyond_double() const { return twofold + structural(); }
};

}  // namespace csgcast
