// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "csg/base/box.h"
#include "csg/base/digits.h"
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

/// Bounds on the errors of a form's coefficients, in the order of QuadricForm::Term.
using FormError = std::array<double, QuadricForm::term_count>;

/// The difference between a leaf's forms and what was meant, as each number that the leaf was made from is known to
/// half an ulp, or to fewer digits. It only decides what welding treats as rounding.
struct ShapeError {
  Vector axes{0x1p-53, 0x1p-53, 0x1p-53};  ///< each axis is scaled by 1 ± its entry, as by sizes
  /// Additional errors of each form about `center`: |off(q)| <= sum of errors[i] |term_i(q - center)|. Empty if there
  /// are none.
  std::vector<FormError> errors;
  Point center;
  Digits digits{};  ///< of the text that the numbers are from
};

/// A leaf in its own coordinates. It is the closed set of points where every form is <= 0 or, if `inside` is set, the
/// closure of the open set that `inside` defines.
struct LeafShape {
  LeafKind kind = LeafKind::convex;

  std::size_t form_count() const { return forms.size() + others.size(); }

  FormList forms;  ///< none of the forms is constant
  /// The forms that are neither planes nor quadrics. There is at least one form here or in `forms`.
  std::vector<std::shared_ptr<const OtherForm>> others;
  /// Defines the inside by which forms are <= 0. Condition k is that of forms[k], or of the forms in `others` after
  /// them. Null if all forms must be.
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
