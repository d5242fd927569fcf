// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "csg/base/vector.h"
#include "csg/exact/other_form.h"
#include "csg/exact/packed_form.h"
#include "raycast/line/frame.h"

namespace csgcast {

struct SurfaceKind;
extern const SurfaceKind plane_kind;
extern const SurfaceKind quadric_kind;

/// One surface of the world, f(p) = 0: its canonical exact form, and floating-point forms of it that only ever filter.
struct Surface {
  using Coefficients = std::array<double, 10>;  ///< in the order of QuadricForm::Term

  const SurfaceKind* kind = &plane_kind;  ///< a row of the table of kinds
  bool is_plane = true;                   ///< kind is &plane_kind: what hot loops ask
  /// Every leaf that owns the surface is bounded: only what happens in the frame's unit cube matters of it.
  bool is_local = true;
  /// False if a coefficient underflowed beside the largest one, or there are none: then the doubles decide nothing.
  bool in_range = true;
  bool is_mixed = false;  ///< it has terms xy, xz or yz

  // What is asked of a surface that a ray hits comes first, side by side.
  double second_degree = 0;  ///< sum of the magnitudes of local's second-degree coefficients
  /// In the frame's coordinates about `center`, f(center + q) times a power of two: each coefficient rounded to
  /// nearest, the largest near 1. The center, which is exact, lies near the leaf that brought a quadric, and is the
  /// frame's own for a plane.
  Coefficients local{};
  Vector center;
  Vector normal{};          ///< of a plane: the gradient, unit, as normalised() gives it
  double first_degree = 0;  ///< sum of the magnitudes of local's first-degree coefficients
  double constant = 0;      ///< of its constant
  /// What the rounding of `local` left over, rounded: local + local_low is off by a relative 2^-106.
  Coefficients local_low{};

  /// In the world's coordinates and times a power of two, rounded likewise.
  Coefficients world{};
  PackedForm exact;  ///< coprime integers, first non-zero one positive; no form if there is another one
  /// The canonical form of a surface that is no plane and no quadric: all of the numbers above are 0 then, and out of
  /// range. Else null.
  std::shared_ptr<const OtherForm> other;
};

/// The floating-point forms of a canonical form. `near` should lie near the part of the surface that is seen; any
/// finite point is right.
Surface make_surface(PackedForm canonical, const Frame& frame, Point near, bool is_local);

/// A surface that is no plane and no quadric, of a kind that takes its form.
Surface make_surface(std::shared_ptr<const OtherForm> canonical, const SurfaceKind& kind, bool is_local);

/// The gradient of the surface's form at p up to a positive factor, in plain double.
Vector gradient(const Surface& surface, const Frame& frame, Point p);

}  // namespace csgcast
