// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "csg/base/box.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/solid.h"
#include "raycast/line/twofold.h"
#include "raycast/surface/rounded_form.h"

// When two surfaces could be one but for errors of their numbers. docs/welding.md has the derivation.

namespace csgcast::detail {

/// Coordinates s about a place: p = center + 2^exponent s.
struct Region {
  Point center;
  int exponent = 0;

  /// About a finite box: |s| <= 1 in it.
  static Region around(const Box& box);
  /// Whether doubles tell its size from its center's last bit; if not, no error about it can be told.
  bool is_resolved() const;
};

/// A surface in a region's coordinates, up to a factor, to a relative 2^-104.
struct RegionForm {
  std::array<Twofold, QuadricForm::term_count> coefficient;
  bool in_range = true;   ///< false: a coefficient underflowed
  bool is_exact = false;  ///< true: not even rounded to that
  bool is_plane = false;

  RegionForm() = default;
  RegionForm(const QuadricForm& form, const Region& region);
};

/// The same surface about another center; both regions must have one exponent. Off by a relative 2^-100 of the
/// magnitudes in the first region.
RegionForm seen_from(const RegionForm& form, const Region& region, const Region& place);

/// An unknown small motion of a surface, in a region's coordinates: s -> s + offset + slope s, each entry known by its
/// greatest magnitude.
struct SmallMotion {
  std::array<double, 3> offset{};
  std::array<double, 9> slope{};
};

/// What an unknown small motion may do to each coefficient, to first order.
FormError error_of(const RegionForm& form, const SmallMotion& motion);

/// How many times their errors two surfaces are apart in the coefficient that tells them apart most, one of them scaled
/// to the other: at most 1 if they could be the same. Infinite if errors are not finite or too large to tell anything.
double distance_in_errors(const RegionForm& f, const FormError& f_error, const RegionForm& g, const FormError& g_error);

/// Whether g is nearer to -f than to f.
bool is_flipped(const RegionForm& f, const RegionForm& g);

/// How far two surfaces are apart at most over a box about the region, in the scene's unit of length; for quadrics
/// about so. Infinite if they have little in common, as a plane and a quadric.
double gap(const RegionForm& f, const RegionForm& g, const Region& region, const Box& box);

}  // namespace csgcast::detail
