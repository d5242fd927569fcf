// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "csg/base/vector.h"
#include "csg/exact/affine.h"
#include "csg/exact/dyadic.h"

namespace csgcast {

/// f(x, y, z) = xx x² + yy y² + zz z² + xy xy + xz xz + yz yz + x x + y y + z z + one, exact.
/// Planes are the forms whose first six coefficients are zero.
struct QuadricForm {
  enum Term : std::size_t { xx, yy, zz, xy, xz, yz, x, y, z, one, term_count };

  /// The second-degree term of two axes.
  static constexpr Term second_degree(std::size_t k, std::size_t l) {
    if (k == l) return static_cast<Term>(xx + k);
    return k + l == 1 ? xy : k + l == 2 ? xz : yz;
  }

  std::array<Dyadic, term_count> coefficient;

  static QuadricForm plane(const Dyadic& nx, const Dyadic& ny, const Dyadic& nz, const Dyadic& offset);

  bool is_plane() const;     ///< no second-degree term, some first-degree term
  bool is_constant() const;  ///< no term but `one`
  Dyadic at(const Point& p) const;
  QuadricForm operator-() const;
  friend bool operator==(const QuadricForm&, const QuadricForm&) = default;
};

/// True if f is convex; then the closed set f <= 0 is convex, too. Decided exactly.
bool is_convex(const QuadricForm& f);

/// Moves surfaces: moved(f) = g such that g(world_from_solid(p)) has the sign of f(p) for every p. g is f(adj(M) p) for
/// a quadric and sign(det) times it for a plane.
class FormMover {
 public:
  /// Precondition: world_from_solid is not singular.
  explicit FormMover(const ExactAffine& world_from_solid);
  QuadricForm moved(const QuadricForm& f) const;

 private:
  // A linear function of the world's coordinates, homogeneous: c[0] x + c[1] y + c[2] z + c[3].
  using LinearForm = std::array<Dyadic, 4>;
  QuadricForm moved_plane(const QuadricForm& f) const;
  static void add_product(QuadricForm& sum, const Dyadic& factor, const LinearForm& a, const LinearForm& b);
  static void add_multiple(QuadricForm& sum, const Dyadic& factor, const LinearForm& a);

  std::array<LinearForm, 3> local_;  // determinant times the solid's coordinates
  Dyadic determinant_;
};

/// One form moved: see FormMover.
inline QuadricForm transformed(const QuadricForm& f, const ExactAffine& world_from_solid) {
  return FormMover(world_from_solid).moved(f);
}

/// A form scaled to coprime integers (exponent 0 or more) whose first non-zero coefficient is positive: equal for
/// proportional forms.
struct CanonicalForm {
  QuadricForm form;
  bool flipped = false;  ///< true if the factor was negative: f <= 0 is where the canonical form is >= 0
};

/// Precondition: f is not constant.
CanonicalForm canonical(QuadricForm f);

}  // namespace csgcast
