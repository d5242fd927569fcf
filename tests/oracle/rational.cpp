// SPDX-License-Identifier: MIT
#include "tests/oracle/rational.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace csgcast::oracle {
namespace {

using Fraction = CGAL::Fraction_traits<Rational>;
using Integer = Fraction::Numerator_type;

}  // namespace

int sign_of(const Rational& number) { return static_cast<int>(CGAL::sign(number)); }

double approximate(const Rational& number) { return CGAL::to_double(number); }

RationalPoint exact(Point p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }

RationalPoint exact(Vector v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

// A decimal integer as the product prints it, times two as often as the exponent says, in steps that are doubles.
Rational rational(const Dyadic& number) {
  Rational value(number.mantissa().get_str());
  for (std::int64_t left = number.exponent(); left != 0;) {
    const std::int64_t step = std::clamp<std::int64_t>(left, -1000, 1000);
    value *= Rational(std::ldexp(1.0, static_cast<int>(step)));
    left -= step;
  }
  return value;
}

Rational primitive_factor(std::span<const Rational> coefficients) {
  Integer numerators = 0;
  Integer denominators = 1;
  for (const Rational& c : coefficients) {
    Integer numerator, denominator;
    Fraction::Decompose()(c, numerator, denominator);
    numerators = CGAL::gcd(numerators, numerator);
    denominators = denominators * CGAL::integral_division(denominator, Integer(CGAL::gcd(denominators, denominator)));
  }
  return Fraction::Compose()(denominators, numerators);
}

Point nearest(const RationalPoint& p) { return {approximate(p[0]), approximate(p[1]), approximate(p[2])}; }

Rational RationalPlane::at(const RationalPoint& p) const { return along(p) + coefficient[3]; }

Rational RationalPlane::along(const RationalPoint& direction) const {
  return coefficient[0] * direction[0] + coefficient[1] * direction[1] + coefficient[2] * direction[2];
}

RationalPlane RationalPlane::primitive() const {
  const Rational factor = primitive_factor(coefficient);
  RationalPlane scaled;
  for (std::size_t i = 0; i < 4; ++i) scaled.coefficient[i] = coefficient[i] * factor;
  return scaled;
}

RationalPlane RationalPlane::operator-() const {
  return {{-coefficient[0], -coefficient[1], -coefficient[2], -coefficient[3]}};
}

int RationalPlane::leading_sign() const {
  for (const Rational& c : coefficient) {
    if (sign_of(c) != 0) return sign_of(c);
  }
  return 0;
}

RationalPlane plane_through(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r) {
  RationalPoint u, v;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = q[i] - p[i];
    v[i] = r[i] - p[i];
  }
  RationalPlane plane;
  plane.coefficient[0] = u[1] * v[2] - u[2] * v[1];
  plane.coefficient[1] = u[2] * v[0] - u[0] * v[2];
  plane.coefficient[2] = u[0] * v[1] - u[1] * v[0];
  plane.coefficient[3] = -plane.along(p);
  return plane;
}

std::vector<RationalPlane> without_duplicates(const std::vector<RationalPlane>& planes) {
  std::vector<RationalPlane> result;
  for (const RationalPlane& plane : planes) result.push_back(plane.primitive());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

RationalAffine::RationalAffine() {
  for (std::size_t i = 0; i < 3; ++i) row_[i][i] = 1;
}

RationalAffine RationalAffine::then(const Transform& outer) const {
  RationalAffine result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      Rational sum = j == 3 ? Rational(outer(i, 3)) : Rational(0);
      for (std::size_t k = 0; k < 3; ++k) sum += Rational(outer(i, k)) * row_[k][j];
      result.row_[i][j] = sum;
    }
  }
  return result;
}

RationalPoint RationalAffine::operator()(const RationalPoint& p) const {
  RationalPoint image;
  for (std::size_t i = 0; i < 3; ++i) image[i] = row_[i][0] * p[0] + row_[i][1] * p[1] + row_[i][2] * p[2] + row_[i][3];
  return image;
}

// Three points of the plane and one off it, inside, all moved: no inverse matrix, unlike the product.
RationalPlane RationalAffine::operator()(const RationalPlane& plane) const {
  const auto& c = plane.coefficient;
  const RationalPoint normal{c[0], c[1], c[2]};
  const Rational square = plane.along(normal);
  const auto off_plane = [&](const RationalPoint& shift) {
    const Rational height = (plane.along(shift) + c[3]) / square;
    RationalPoint p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = shift[i] - height * normal[i];
    return p;
  };
  std::array<RationalPoint, 4> corner;  // the foot of the origin and of the three unit points
  for (std::size_t i = 0; i < 3; ++i) {
    RationalPoint unit;
    unit[i] = 1;
    corner[i + 1] = off_plane(unit);
  }
  corner[0] = off_plane({});
  RationalPoint inside;
  for (std::size_t i = 0; i < 3; ++i) inside[i] = corner[0][i] - normal[i];
  const RationalPoint moved_inside = (*this)(inside);
  // Two of the three unit points and the origin have feet that are not on one line.
  for (std::size_t i = 1; i <= 3; ++i) {
    const RationalPlane image = plane_through((*this)(corner[0]), (*this)(corner[i]), (*this)(corner[i % 3 + 1]));
    const int side = sign_of(image.at(moved_inside));
    if (side != 0) return side < 0 ? image : -image;
  }
  throw std::logic_error("a singular map has no image of a half-space");
}

}  // namespace csgcast::oracle
