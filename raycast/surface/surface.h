// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "csg/base/vector.h"
#include "csg/exact/packed_form.h"
#include "raycast/line/frame.h"

namespace csgcast {

enum class SurfaceKind : std::uint8_t { plane, quadric };

/// One surface of the world, f(p) = 0: its canonical exact form, and floating-point forms that only filter: where their
/// error bounds leave a decision open, the exact form takes it.
struct Surface {
  using Coefficients = std::array<double, QuadricForm::term_count>;

  SurfaceKind kind = SurfaceKind::plane;
  /// True if every leaf that owns the surface is bounded. Then only what it does in the frame's unit cube matters.
  bool is_local = true;
  /// False if a coefficient is so small beside the largest one that it underflowed: then the doubles decide nothing.
  bool in_range = true;
  bool is_mixed = false;  ///< it has terms xy, xz or yz

  // What is needed for each ray that hits the surface comes first and lies side by side.
  double second_degree = 0;  ///< sum of the magnitudes of local's second-degree coefficients
  /// The form in the frame's coordinates about `center`: f(center + q) times a power of two, with each coefficient
  /// rounded to nearest and the largest one near 1. The center is exact. For a quadric it lies near the leaf that
  /// brought the surface, for a plane it is the frame's own.
  Coefficients local{};
  Vector center;
  Vector normal{};          ///< for a plane: the gradient, unit, as normalised() gives it
  double first_degree = 0;  ///< sum of the magnitudes of local's first-degree coefficients
  double constant = 0;      ///< magnitude of local's constant
  /// What the rounding of `local` left over, itself rounded: local + local_low is off by a relative 2^-106.
  Coefficients local_low{};

  /// The form in the world's coordinates, times a power of two and rounded likewise.
  Coefficients world{};
  PackedForm exact;  ///< coprime integers, first non-zero one positive
};

/// A surface of a canonical form, with its floating-point forms in a frame. `near` should lie near the part of the
/// surface that is seen, where the forms are then most accurate; any finite point is right.
Surface make_surface(PackedForm canonical, const Frame& frame, Point near, bool is_local);

/// The gradient of the surface's form at p, up to a positive factor, in plain double.
Vector gradient(const Surface& surface, const Frame& frame, Point p);

}  // namespace csgcast
