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

/// One surface of the world, f(p) = 0. It has a canonical exact form, and floating-point forms that are used as filters
/// only.
struct Surface {
  using Coefficients = std::array<double, 10>;  ///< in the order of QuadricForm::Term

  const SurfaceKind* kind = &plane_kind;  ///< a row of the table of kinds
  bool is_plane = true;                   ///< true if kind is &plane_kind; hot loops ask for this
  /// True if every leaf that owns the surface is bounded, or below a node that is cut (Node::is_cut). Then the surface
  /// matters in the frame's unit cube only.
  bool is_local = true;
  /// False if a coefficient underflowed beside the largest one, or if there are no coefficients. Then the doubles
  /// decide nothing.
  bool in_range = true;
  bool is_mixed = false;  ///< true if it has terms xy, xz or yz

  // The members that are needed for a surface that a ray hits come first, side by side.
  double second_degree = 0;  ///< sum of the magnitudes of local's second-degree coefficients
  /// The form in the frame's coordinates about `center`: f(center + q) times a power of two. Each coefficient is
  /// rounded to nearest, and the largest is near 1. The center is exact. For a quadric it lies near the leaf that
  /// brought the surface; for a plane it is the frame's own.
  Coefficients local{};
  Vector center;
  Vector normal{};          ///< for a plane: the unit gradient, as normalised() gives it
  double first_degree = 0;  ///< sum of the magnitudes of local's first-degree coefficients
  double constant = 0;      ///< magnitude of local's constant
  /// What the rounding of `local` left over, rounded. The sum local + local_low is off by a relative 2^-106.
  Coefficients local_low{};

  /// The form in the world's coordinates times a power of two, also rounded to nearest.
  Coefficients world{};
  PackedForm exact;  ///< coprime integers, the first one that is not zero positive; no form if `other` is set
  /// The canonical form of a surface that is neither a plane nor a quadric, else null. If it is set, all of the numbers
  /// above are 0, and out of range.
  std::shared_ptr<const OtherForm> other;
};

/// Makes the floating-point forms of a canonical form. `near` should lie near the part of the surface that is seen, but
/// the result is valid for any finite point.
Surface make_surface(PackedForm canonical, const Frame& frame, Point near, bool is_local);

/// Makes a surface that is neither a plane nor a quadric, of a kind that takes its form.
Surface make_surface(std::shared_ptr<const OtherForm> canonical, const SurfaceKind& kind, bool is_local);

/// The gradient of the surface's form at p up to a positive factor, in plain double.
Vector gradient(const Surface& surface, const Frame& frame, Point p);

}  // namespace csgcast
