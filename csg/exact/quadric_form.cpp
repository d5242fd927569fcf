// SPDX-License-Identifier: MIT
#include "csg/exact/quadric_form.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "csg/base/precondition.h"

namespace csgcast {
namespace {

using Term = QuadricForm::Term;
constexpr std::array<Term, 3> first_degree{Term::x, Term::y, Term::z};

}  // namespace

QuadricForm QuadricForm::plane(const Dyadic& nx, const Dyadic& ny, const Dyadic& nz, const Dyadic& offset) {
  QuadricForm f;
  f.coefficient[Term::x] = nx;
  f.coefficient[Term::y] = ny;
  f.coefficient[Term::z] = nz;
  f.coefficient[Term::one] = offset;
  return f;
}

bool QuadricForm::is_constant() const {
  return std::all_of(coefficient.begin(), coefficient.begin() + Term::one, [](const Dyadic& c) { return c.is_zero(); });
}

bool QuadricForm::is_plane() const {
  return !is_constant() &&
         std::all_of(coefficient.begin(), coefficient.begin() + Term::x, [](const Dyadic& c) { return c.is_zero(); });
}

Dyadic QuadricForm::at(const Point& p) const {
  Dyadic value = coefficient[one];
  for (std::size_t i = 0; i < 3; ++i) {
    Dyadic slope = coefficient[first_degree[i]];
    for (std::size_t j = i; j < 3; ++j) {
      const Dyadic& second = coefficient[QuadricForm::second_degree(i, j)];
      if (!second.is_zero()) slope += second * Dyadic(p[j]);
    }
    value += slope * Dyadic(p[i]);
  }
  return value;
}

QuadricForm QuadricForm::operator-() const {
  QuadricForm negated = *this;
  for (Dyadic& c : negated.coefficient) c = -c;
  return negated;
}

// The criterion is that the symmetric matrix of the second degree has no negative principal minor. The code uses twice
// that matrix.
bool is_convex(const QuadricForm& f) {
  const auto& c = f.coefficient;
  const auto minor = [&](std::size_t i, std::size_t j) {
    const Dyadic& mixed = c[QuadricForm::second_degree(i, j)];
    return Dyadic(4) * c[QuadricForm::xx + i] * c[QuadricForm::xx + j] - mixed * mixed;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    if (c[QuadricForm::xx + i].sign() < 0 || minor(i, (i + 1) % 3).sign() < 0) return false;
  }
  const Dyadic determinant = c[QuadricForm::xx] * minor(1, 2) +
                             c[QuadricForm::xy] * c[QuadricForm::xz] * c[QuadricForm::yz] -
                             c[QuadricForm::yy] * c[QuadricForm::xz] * c[QuadricForm::xz] -
                             c[QuadricForm::zz] * c[QuadricForm::xy] * c[QuadricForm::xy];
  return determinant.sign() >= 0;
}

FormMover::FormMover(const ExactAffine& world_from_solid) : determinant_(world_from_solid.determinant()) {
  CSGCAST_PRECONDITION(!determinant_.is_zero());
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      local_[i][j] = world_from_solid.adjugate(i, j);
      local_[i][3] -= local_[i][j] * world_from_solid.offset(j);
    }
  }
}

void FormMover::add_product(QuadricForm& sum, const Dyadic& factor, const LinearForm& a, const LinearForm& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (a[i].is_zero() || b[j].is_zero()) continue;
      sum.coefficient[QuadricForm::second_degree(i, j)] += factor * a[i] * b[j];
    }
    sum.coefficient[first_degree[i]] += factor * (a[i] * b[3] + a[3] * b[i]);
  }
  sum.coefficient[Term::one] += factor * a[3] * b[3];
}

void FormMover::add_multiple(QuadricForm& sum, const Dyadic& factor, const LinearForm& a) {
  for (std::size_t i = 0; i < 3; ++i) sum.coefficient[first_degree[i]] += factor * a[i];
  sum.coefficient[Term::one] += factor * a[3];
}

QuadricForm FormMover::moved_plane(const QuadricForm& f) const {
  QuadricForm g;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!f.coefficient[first_degree[i]].is_zero()) add_multiple(g, f.coefficient[first_degree[i]], local_[i]);
  }
  g.coefficient[Term::one] += f.coefficient[Term::one] * determinant_;
  return determinant_.sign() < 0 ? -g : g;
}

QuadricForm FormMover::moved(const QuadricForm& f) const {
  if (f.is_plane()) return moved_plane(f);
  // f(adj(M) (p - b) / det) times det², which is positive.
  QuadricForm g;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const Dyadic& c = f.coefficient[QuadricForm::second_degree(i, j)];
      if (!c.is_zero()) add_product(g, c, local_[i], local_[j]);
    }
    const Dyadic& c = f.coefficient[first_degree[i]];
    if (!c.is_zero()) add_multiple(g, c * determinant_, local_[i]);
  }
  g.coefficient[Term::one] += f.coefficient[Term::one] * determinant_ * determinant_;
  return g;
}

CanonicalForm canonical(QuadricForm f) {
  CSGCAST_PRECONDITION(!f.is_constant());
  static const Dyadic one(1.0);
  // Mantissas are odd, so the coefficients' greatest common divisor comes from that of the mantissas and the least
  // exponent.
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  Dyadic divisor;
  for (const Dyadic& c : f.coefficient) {
    if (c.is_zero()) continue;
    least = std::min(least, c.exponent());
    if (divisor != one) divisor = common_divisor(divisor, c);
  }
  const auto leading =
      std::find_if(f.coefficient.begin(), f.coefficient.end(), [](const Dyadic& c) { return !c.is_zero(); });
  const bool flipped = leading->sign() < 0;
  CanonicalForm result{std::move(f), flipped};
  for (Dyadic& c : result.form.coefficient) {
    if (c.is_zero()) continue;
    if (divisor != one) c = exact_quotient(c, divisor);
    c = std::move(c).scaled(-least);
    if (result.flipped) c = -std::move(c);
  }
  return result;
}

}  // namespace csgcast
