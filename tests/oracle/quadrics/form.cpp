// SPDX-License-Identifier: MIT
#include "tests/oracle/quadrics/form.h"

#include <stdexcept>
#include <utility>

namespace csgcast::oracle::quadrics {
namespace {

using Term = QuadricForm::Term;

// Which two homogeneous coordinates (x, y, z, 1) each term multiplies.
constexpr std::array<std::pair<std::size_t, std::size_t>, 10> factors{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}, {3, 3}}};
static_assert(Term::xx == 0 && Term::yz == 5 && Term::x == 6 && Term::one == 9);

using Homogeneous = std::array<Rational, 4>;

Homogeneous homogeneous(const RationalPoint& p, int weight) { return {p[0], p[1], p[2], Rational(weight)}; }

}  // namespace

RationalForm::RationalForm(const QuadricForm& form) {
  for (std::size_t i = 0; i < coefficient.size(); ++i) coefficient[i] = rational(form.coefficient[i]);
}

Rational RationalForm::at(const RationalPoint& p) const { return along({p, {}}).value; }

LinePolynomial RationalForm::along(const RationalLine& line) const {
  const Homogeneous o = homogeneous(line.origin, 1);
  const Homogeneous d = homogeneous(line.direction, 0);
  LinePolynomial result;
  for (std::size_t i = 0; i < coefficient.size(); ++i) {
    if (sign_of(coefficient[i]) == 0) continue;
    const auto [j, k] = factors[i];
    result.square += coefficient[i] * d[j] * d[k];
    result.slope += coefficient[i] * (o[j] * d[k] + o[k] * d[j]);
    result.value += coefficient[i] * o[j] * o[k];
  }
  return result;
}

int RationalForm::leading_sign() const {
  for (const Rational& c : coefficient) {
    if (sign_of(c) != 0) return sign_of(c);
  }
  return 0;
}

RationalForm RationalForm::normalised() const {
  const Rational factor = leading_sign() * primitive_factor(coefficient);
  RationalForm result;
  for (std::size_t i = 0; i < coefficient.size(); ++i) result.coefficient[i] = coefficient[i] * factor;
  return result;
}

SolidFromWorld::SolidFromWorld() {
  for (std::size_t i = 0; i < 4; ++i) matrix_[i][i] = 1;
}

SolidFromWorld SolidFromWorld::inside(const Transform& world_from_solid) const {
  SolidFromWorld result;
  result.matrix_ = product(inverse(world_from_solid), matrix_);
  return result;
}

// The symmetric matrix of f is S; that of f(M p) is MᵀSM.
RationalForm SolidFromWorld::pulled_back(const RationalForm& f) const {
  Matrix symmetric;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const auto [j, k] = factors[i];
    symmetric[j][k] = j == k ? f.coefficient[i] : Rational(f.coefficient[i] / 2);
    symmetric[k][j] = symmetric[j][k];
  }
  const Matrix right = product(symmetric, matrix_);
  RationalForm result;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const auto [j, k] = factors[i];
    for (std::size_t row = 0; row < 4; ++row) result.coefficient[i] += matrix_[row][j] * right[row][k];
    if (j != k) result.coefficient[i] *= 2;
  }
  return result;
}

// Gauss and Jordan, on the matrix with the identity beside it.
SolidFromWorld::Matrix SolidFromWorld::inverse(const Transform& transform) {
  Matrix left;
  Matrix right;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) left[i][j] = i < 3 ? Rational(transform(i, j)) : Rational(j == 3 ? 1 : 0);
    right[i][i] = 1;
  }
  for (std::size_t column = 0; column < 4; ++column) {
    std::size_t pivot = column;
    while (pivot < 4 && sign_of(left[pivot][column]) == 0) ++pivot;
    if (pivot == 4) throw std::logic_error("a singular transform in a solid");
    std::swap(left[pivot], left[column]);
    std::swap(right[pivot], right[column]);
    const Rational divisor = left[column][column];
    for (std::size_t j = 0; j < 4; ++j) {
      left[column][j] /= divisor;
      right[column][j] /= divisor;
    }
    for (std::size_t row = 0; row < 4; ++row) {
      const Rational factor = left[row][column];
      if (row == column || sign_of(factor) == 0) continue;
      for (std::size_t j = 0; j < 4; ++j) {
        left[row][j] -= factor * left[column][j];
        right[row][j] -= factor * right[column][j];
      }
    }
  }
  return right;
}

SolidFromWorld::Matrix SolidFromWorld::product(const Matrix& a, const Matrix& b) {
  Matrix result;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) result[i][j] += a[i][k] * b[k][j];
    }
  }
  return result;
}

}  // namespace csgcast::oracle::quadrics
