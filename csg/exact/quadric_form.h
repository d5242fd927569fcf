// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "csg/exact/affine.h"
#include "csg/exact/dyadic.h"
#include "csg/vector.h"

namespace csgcast {

/// f(x, y, z) = xx x² + yy y² + zz z² + xy xy + xz xz + yz yz + x x + y y + z z + one, exact.
/// Planes are the forms whose first six coefficients are zero.
struct QuadricForm {
  enum Term : std::size_t { xx, yy, zz, xy, xz, yz, x, y, z, one, term_count };

  std::array<Dyadic, term_count> coefficient;

  static QuadricForm plane(const Dyadic& nx, const Dyadic& ny, const Dyadic& nz, const Dyadic& offset);

  bool is_plane() const;     ///< no second-degree term, some first-degree term
  bool is_constant() const;  ///< no term but `one`
  Dyadic at(const Point& p) const;
  QuadricForm operator-() const;
  friend bool operator==(const QuadricForm&, const QuadricForm&) = default;
};

/// The form g of the moved surface: g(world_from_solid(p)) has the sign of f(p) for every p.
/// Precondition: world_from_solid is not singular. g is f(adj(M) p) for a quadric and sign(det) times it for a plane.
QuadricForm transformed(const QuadricForm& f, const ExactAffine& world_from_solid);

/// A form scaled to coprime integers (exponent 0 or more) whose first non-zero coefficient is positive: equal for proportional forms.
struct CanonicalForm {
  QuadricForm form;
  bool flipped = false;  ///< true if the factor was negative: f <= 0 is where the canonical form is >= 0
};

/// Precondition: f is not constant.
CanonicalForm canonical(const QuadricForm& f);

}  // namespace csgcast
