// SPDX-License-Identifier: MIT
#include "csg/exact/symmetric_eigen.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "csg/exact/dyadic.h"

namespace csgcast {
namespace {

using Eigen::Index;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

SymmetricEigen unknown() {
  SymmetricEigen result;
  result.value.fill(none);
  result.axis.fill({none, none, none});
  result.angle.fill(infinity);
  result.value_error = infinity;
  return result;
}

Dyadic magnitude(const Dyadic& x) { return x.sign() < 0 ? -x : x; }

using Exact = std::array<std::array<Dyadic, 3>, 3>;

/// The sum of the magnitudes of all entries: no less than the spectral norm.
Dyadic size_of(const Exact& m) {
  Dyadic sum;
  for (const auto& row : m) {
    for (const Dyadic& entry : row) sum += magnitude(entry);
  }
  return sum;
}

Exact exact(const Eigen::Matrix3d& m) {
  Exact result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = m(static_cast<Index>(i), static_cast<Index>(j));
  }
  return result;
}

/// What the true matrix differs from Q L Q' at most, for an orthogonal Q near V and L = diag(value); and what V differs
/// from Q: spectral norms.
///
/// Q is V's polar factor: |V - Q| <= |V'V - 1|. |A Q - Q L| <= |A V - V L| + |V - Q| (|A| + |L|), and the true matrix
/// is within 3 entry_error of A.
struct Residual {
  Dyadic matrix;
  Dyadic axes;
};

Residual residual(const Exact& a, const Exact& v, const std::array<double, 3>& value, double entry_error) {
  Exact off, gram;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      off[i][j] = -(v[i][j] * Dyadic(value[j]));
      gram[i][j] = i == j ? -1.0 : 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        off[i][j] += a[i][k] * v[k][j];
        gram[i][j] += v[k][i] * v[k][j];
      }
    }
  }
  Dyadic greatest;
  for (const double x : value) greatest = std::max(greatest, magnitude(x));
  const Dyadic axes = size_of(gram);
  return {Dyadic(3.0) * Dyadic(entry_error) + size_of(off) + axes * (size_of(a) + greatest), axes};
}

/// The longest component of the first two made positive, and the third square to both on their right-handed side.
void orient(Eigen::Matrix3d& v) {
  for (Index k = 0; k < 2; ++k) {
    Index longest = 0;
    v.col(k).cwiseAbs().maxCoeff(&longest);
    if (v(longest, k) < 0) v.col(k) = -v.col(k);
  }
  if (v.determinant() < 0) v.col(2) = -v.col(2);
  v = v.array() + 0.0;  // no -0
}

/// Radians, at most: q the solver's axis made exact, then that of V. |r| = |A q - l q| <= matrix, and the other true
/// eigenvalues are at least gap - matrix from l. So sin <= matrix / (gap - matrix).
double angle_bound(const Residual& off, const Dyadic& gap) {
  const Dyadic rest = gap - off.matrix;
  if (!(rest > off.matrix)) return infinity;
  // Roundings of a quotient, an arc sine and a sum are less than 2^-50 of the result.
  const double sine = off.matrix.rounded_up() / rest.rounded_down() * (1 + 0x1p-50);
  if (!(sine < 1)) return infinity;
  return (std::asin(sine) + 2 * off.axes.rounded_up()) * (1 + 0x1p-50);
}

}  // namespace

SymmetricEigen symmetric_eigen(const std::array<double, 6>& matrix, double entry_error) {
  const auto is_finite = [](double x) { return std::isfinite(x); };
  if (!std::all_of(matrix.begin(), matrix.end(), is_finite) || !std::isfinite(entry_error)) return unknown();
  const auto& [xx, yy, zz, xy, xz, yz] = matrix;
  Eigen::Matrix3d a;
  a << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a);
  if (solver.info() != Eigen::Success || !solver.eigenvalues().allFinite() || !solver.eigenvectors().allFinite())
    return unknown();
  Eigen::Matrix3d v = solver.eigenvectors();
  orient(v);
  SymmetricEigen result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Index>(i);
    result.value[i] = solver.eigenvalues()[k] + 0.0;
    result.axis[i] = {v(0, k), v(1, k), v(2, k)};
  }
  const Residual off = residual(exact(a), exact(v), result.value, entry_error);
  result.value_error = off.matrix.rounded_up();
  for (std::size_t i = 0; i < 3; ++i) {
    // The distance to the nearer neighbour; exact, as near ones cancel.
    const Dyadic below = i > 0 ? Dyadic(result.value[i]) - Dyadic(result.value[i - 1]) : Dyadic();
    const Dyadic above = i < 2 ? Dyadic(result.value[i + 1]) - Dyadic(result.value[i]) : Dyadic();
    result.angle[i] = angle_bound(off, i == 0 ? above : i == 2 ? below : std::min(below, above));
  }
  return result;
}

}  // namespace csgcast
