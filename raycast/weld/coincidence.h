// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "csg/base/box.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/solid.h"
#include "raycast/line/twofold.h"
#include "raycast/surface/rounded_form.h"

// These functions tell when two surfaces could be one, but for errors of their numbers. docs/welding.md has the
// derivation.

namespace csgcast::detail {

/// Coordinates s about a place: p = center + 2^exponent s.
struct Region {
  Point center;
  int exponent = 0;

  /// The region about a finite box, in which |s| <= 1.
  static Region around(const Box& box);
  /// False if the region is so small, compared with its center's coordinates, that doubles cannot represent errors in
  /// it.
  bool is_resolved() const;
};

/// A surface's form in a region's coordinates, up to a factor. Its coefficients are off by a relative 2^-104.
struct RegionForm {
  std::array<Twofold, QuadricForm::term_count> coefficient;
  bool in_range = true;   ///< false if a coefficient underflowed
  bool is_exact = false;  ///< true if nothing was rounded
  bool is_plane = false;

  RegionForm() = default;
  RegionForm(const QuadricForm& form, const Region& region);
};

/// The same surface in a region about another center. It is off by 2^-100 of the magnitudes in the first region.
/// Precondition: both regions have the same exponent.
RegionForm seen_from(const RegionForm& form, const Region& region, const Region& place);

/// An unknown small motion of a surface, in a region's coordinates: s -> s + offset + slope s. Each entry is the
/// greatest magnitude that the entry of the motion may have.
struct SmallMotion {
  std::array<double, 3> offset{};
  std::array<double, 9> slope{};
};

/// The most that an unknown small motion may change each coefficient, to first order.
FormError error_of(const RegionForm& form, const SmallMotion& motion);

/// The distance of two surfaces in multiples of their errors. It is at most 1 if they could be the same. One surface is
/// scaled to the other, and the coefficient in which they differ most counts. The distance is infinite if errors are
/// not finite, or above `most_error`, a share of the largest coefficient: the numbers determine nothing then.
double distance_in_errors(const RegionForm& f, const FormError& f_error, const RegionForm& g, const FormError& g_error,
                          double most_error);

/// True if g is nearer to -f than to f.
bool is_flipped(const RegionForm& f, const RegionForm& g);

/// The greatest distance of two surfaces over a box about the region, in the scene's unit of length. For quadrics it is
/// an estimate. It is infinite if the surfaces have little in common, such as a plane and a quadric.
double gap(const RegionForm& f, const RegionForm& g, const Region& region, const Box& box);

}  // namespace csgcast::detail
