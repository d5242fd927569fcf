// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "csg/exact/quadric_form.h"
#include "tests/oracle/rational.h"

namespace csgcast::oracle::quadrics {

/// What a form is along a line: square t² + slope t + value.
struct LinePolynomial {
  Rational square;
  Rational slope;
  Rational value;
};

/// The line origin + t direction.
struct RationalLine {
  RationalPoint origin;
  RationalPoint direction;
};

/// A polynomial of degree two in x, y and z, or one: the half-space where it is <= 0, or the surface where it is 0.
struct RationalForm {
  std::array<Rational, 10> coefficient;  ///< in the order of QuadricForm::Term

  /// The product's numbers as they stand, which are exact.
  explicit RationalForm(const QuadricForm& form);
  RationalForm() = default;

  Rational at(const RationalPoint& p) const;
  LinePolynomial along(const RationalLine& line) const;
  /// Coprime integers, the first that is not zero positive: equal exactly for one surface. Precondition: not constant.
  RationalForm normalised() const;
  /// The sign of the first coefficient that is not zero.
  int leading_sign() const;

  friend bool operator==(const RationalForm&, const RationalForm&) = default;
  friend bool operator<(const RationalForm& a, const RationalForm& b) { return a.coefficient < b.coefficient; }
};

/// An affine map from the world to a solid's own coordinates: what its surfaces are pulled back by.
class SolidFromWorld {
 public:
  SolidFromWorld();  ///< the identity
  /// The map to the coordinates of what stands inside one more transform, whose matrix is inverted here. Precondition:
  /// it is not singular.
  SolidFromWorld inside(const Transform& world_from_solid) const;
  /// f as a function of the world's coordinates: p -> f(map(p)).
  RationalForm pulled_back(const RationalForm& f) const;

 private:
  using Matrix = std::array<std::array<Rational, 4>, 4>;
  static Matrix inverse(const Transform& transform);
  static Matrix product(const Matrix& a, const Matrix& b);

  Matrix matrix_;  // homogeneous: the last row is 0 0 0 1
};

}  // namespace csgcast::oracle::quadrics
