// SPDX-License-Identifier: MIT
#pragma once

#include <CGAL/Exact_rational.h>

#include <array>
#include <span>
#include <vector>

#include "csg/base/transform.h"
#include "csg/base/vector.h"
#include "csg/exact/dyadic.h"

namespace csgcast::oracle {

/// CGAL's own exact field, over GMP: none of the product's arithmetic. Its operators return expression templates: never
/// keep one in an `auto`.
using Rational = CGAL::Exact_rational;
using RationalPoint = std::array<Rational, 3>;

/// -1, 0 or 1.
int sign_of(const Rational& number);
/// Within an ulp, exact if the number is a double; infinite beyond the doubles.
double approximate(const Rational& number);

RationalPoint exact(Point p);
RationalPoint exact(Vector v);
/// The product's number, read as mantissa and exponent.
Rational rational(const Dyadic& number);
/// The positive number that makes coefficients coprime integers. Precondition: not all are zero.
Rational primitive_factor(std::span<const Rational> coefficients);
/// Within an ulp: for choosing queries, never for judging answers.
Point nearest(const RationalPoint& p);

/// The closed half-space a x + b y + c z + d <= 0.
struct RationalPlane {
  std::array<Rational, 4> coefficient;

  Rational at(const RationalPoint& p) const;
  Rational along(const RationalPoint& direction) const;  ///< (a, b, c) . direction
  /// Times the positive number that makes the coefficients coprime integers: equal for equal half-spaces.
  RationalPlane primitive() const;
  RationalPlane operator-() const;
  /// The sign of the first non-zero coefficient.
  int leading_sign() const;
  friend bool operator==(const RationalPlane&, const RationalPlane&) = default;
  friend bool operator<(const RationalPlane& a, const RationalPlane& b) { return a.coefficient < b.coefficient; }
};

/// The plane through three points, a x + b y + c z + d being positive on the side to which (q - p) x (r - p) points.
RationalPlane plane_through(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r);
/// Sorted, each half-space once.
std::vector<RationalPlane> without_duplicates(const std::vector<RationalPlane>& planes);

/// A composition of transforms, exact.
class RationalAffine {
 public:
  RationalAffine();  ///< the identity
  /// First this, then `outer`.
  RationalAffine then(const Transform& outer) const;
  RationalPoint operator()(const RationalPoint& p) const;
  /// The image of a half-space; the map must not be singular.
  RationalPlane operator()(const RationalPlane& plane) const;

 private:
  std::array<std::array<Rational, 4>, 3> row_;
};

}  // namespace csgcast::oracle
