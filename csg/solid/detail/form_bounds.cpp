// SPDX-License-Identifier: MIT
#include "csg/solid/detail/form_bounds.h"

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "csg/exact/directed.h"

namespace csgcast::detail {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// f(p) = pᵀAp + 2 bᵀp + c.
struct MatrixForm {
  std::array<std::array<Dyadic, 3>, 3> a;
  std::array<Dyadic, 3> b;
  Dyadic c;

  bool has(std::size_t variable) const {
    return !a[variable][0].is_zero() || !a[variable][1].is_zero() || !a[variable][2].is_zero() ||
           !b[variable].is_zero();
  }
};

MatrixForm matrix_form(const QuadricForm& f) {
  using Q = QuadricForm;
  const auto half = [&f](Q::Term term) { return f.coefficient[term].scaled(-1); };
  MatrixForm m;
  m.a = {{{f.coefficient[Q::xx], half(Q::xy), half(Q::xz)},
          {half(Q::xy), f.coefficient[Q::yy], half(Q::yz)},
          {half(Q::xz), half(Q::yz), f.coefficient[Q::zz]}}};
  m.b = {half(Q::x), half(Q::y), half(Q::z)};
  m.c = f.coefficient[Q::one];
  return m;
}

// uᵀ adj(B) v for the block B of A that belongs to `others` (at most two), and its determinant.
struct Block {
  Block(const MatrixForm& form, const std::vector<std::size_t>& variables) : m(form), others(variables) {
    if (others.size() == 1) determinant = m.a[others[0]][others[0]];
    if (others.size() == 2) {
      determinant =
          m.a[others[0]][others[0]] * m.a[others[1]][others[1]] - m.a[others[0]][others[1]] * m.a[others[0]][others[1]];
    }
  }

  bool is_positive_definite() const {
    return others.empty() || (m.a[others[0]][others[0]].sign() > 0 && determinant.sign() > 0);
  }

  Dyadic adjugate_product(const std::array<Dyadic, 3>& u, const std::array<Dyadic, 3>& v) const {
    if (others.empty()) return {};
    const std::size_t i = others[0];
    if (others.size() == 1) return u[i] * v[i];
    const std::size_t j = others[1];
    return u[i] * v[i] * m.a[j][j] + u[j] * v[j] * m.a[i][i] - (u[i] * v[j] + u[j] * v[i]) * m.a[i][j];
  }

  const MatrixForm& m;
  const std::vector<std::size_t>& others;
  Dyadic determinant = Dyadic(1.0);
};

struct Extent {
  double lower = -infinity;
  double upper = infinity;
};

// The range in which alpha t² + 2 beta t + gamma <= 0, rounded outward. Nothing if there is none.
std::optional<Extent> solution_hull(const Dyadic& alpha, const Dyadic& beta, const Dyadic& gamma) {
  if (alpha.sign() < 0) return Extent{};
  if (alpha.is_zero()) {
    if (beta.is_zero()) return gamma.sign() > 0 ? std::nullopt : std::optional(Extent{});
    const Dyadic slope = beta.scaled(1);
    if (slope.sign() > 0) return Extent{-infinity, quotient(-gamma, slope, Toward::up).rounded_up()};
    return Extent{quotient(-gamma, slope, Toward::down).rounded_down(), infinity};
  }
  const Dyadic discriminant = beta * beta - alpha * gamma;
  if (discriminant.sign() < 0) return std::nullopt;
  const Dyadic root = square_root(discriminant, Toward::up);
  return Extent{quotient(-beta - root, alpha, Toward::down).rounded_down(),
                quotient(root - beta, alpha, Toward::up).rounded_up()};
}

// The extent along one axis: f minimised over the other variables, times the determinant of their block, is a quadratic
// in this one.
std::optional<Extent> extent_along(const MatrixForm& m, std::size_t axis) {
  std::vector<std::size_t> others;
  for (std::size_t variable = 0; variable < 3; ++variable) {
    if (variable != axis && m.has(variable)) others.push_back(variable);
  }
  const Block block(m, others);
  if (!block.is_positive_definite()) return Extent{};
  const std::array<Dyadic, 3>& row = m.a[axis];
  return solution_hull(row[axis] * block.determinant - block.adjugate_product(row, row),
                       m.b[axis] * block.determinant - block.adjugate_product(row, m.b),
                       m.c * block.determinant - block.adjugate_product(m.b, m.b));
}

}  // namespace

Box bounds(const QuadricForm& f) {
  const MatrixForm m = matrix_form(f);
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::optional<Extent> extent = extent_along(m, axis);
    if (!extent) return {};
    box.lower[axis] = extent->lower;
    box.upper[axis] = extent->upper;
  }
  return box;
}

}  // namespace csgcast::detail
