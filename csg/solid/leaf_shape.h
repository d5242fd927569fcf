// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "csg/base/box.h"
#include "csg/base/truth_formula.h"
#include "csg/exact/form_list.h"
#include "csg/exact/other_form.h"
#include "csg/solid/solid.h"

namespace csgcast {

/// The disc x² + y² <= radius² at height z.
struct Disc {
  double z = 0;
  double radius = 0;
};

/// How far a form's coefficients may be off, in the order of QuadricForm::Term.
using FormError = std::array<double, QuadricForm::term_count>;

/// How far a leaf's forms may be off from what was meant, if each number it was made from is known to half an ulp.
/// Nothing is decided by it but what welding takes for rounding.
struct ShapeError {
  bool scales_with_axes = true;  ///< each axis scaled by 1 ± 2^-53: what sizes known to half an ulp come to
  /// More than that, of each form about `center`: |off(q)| <= sum of errors[i] |term_i(q - center)|; or empty: nothing.
  std::vector<FormError> errors;
  Point center;
};

/// What a leaf is in its own coordinates: the closed set of points where every form is <= 0, or, with `inside`, the
/// closure of the open set that it tells.
struct LeafShape {
  LeafKind kind = LeafKind::convex;

  std::size_t form_count() const { return forms.size() + others.size(); }

  FormList forms;  ///< none of them constant
  /// The forms that are no plane's and no quadric's; at least one form is here or there.
  std::vector<std::shared_ptr<const OtherForm>> others;
  /// Tells the inside by which forms are <= 0: condition k is that of forms[k], or of those in `others` after them.
  /// Null: all of them are.
  std::shared_ptr<const TruthFormula> inside;
  Box bounds;  ///< holds the set, rounded outward
  bool is_convex_polyhedron = false;
  std::vector<Point>
      vertices;             ///< of a bounded polyhedron given by points (for tight bounds of moved solids); else empty
  std::vector<Disc> discs;  ///< the convex hull of these holds the set, rounded outward (for the same); or empty
  std::optional<Vector> semi_axes;  ///< the ellipsoid about the origin with these holds the set (for the same)
  ShapeError error;
};

}  // namespace csgcast
