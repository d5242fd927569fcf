// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "csg/exact/quadric_form.h"
#include "csg/vector.h"

namespace csgcast {

enum class SurfaceKind : std::uint8_t { plane, quadric };

/// One surface of the world, f(p) = 0: its canonical exact form, and floating-point forms of it that only ever filter.
struct Surface {
  SurfaceKind kind = SurfaceKind::plane;
  QuadricForm exact;  ///< coprime integers, first non-zero one positive

  /// coefficient[i] = exact.coefficient[i] 2^-scale rounded to nearest, the largest near 1: relative error at most
  /// 2^-53 each.
  std::array<double, QuadricForm::term_count> coefficient{};
  std::int64_t scale = 0;
  bool in_range = true;  ///< false if a coefficient underflowed beside the largest: then the doubles decide nothing

  /// For quadrics: the same about `center`, f(center + q) 2^-center_scale; the centre lies near the leaf that brought
  /// the surface.
  Point center;
  std::array<double, QuadricForm::term_count> centered{};
};

/// The floating-point forms of a canonical form. `center` should lie near the part of the surface that is seen; any
/// finite point is right.
Surface make_surface(QuadricForm canonical, Point center);

/// The gradient of the surface's form at p up to a positive factor, in plain double.
Vector gradient(const Surface& surface, Point p);

}  // namespace csgcast
