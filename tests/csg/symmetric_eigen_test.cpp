// SPDX-License-Identifier: MIT
#include "csg/exact/symmetric_eigen.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "csg/base/length.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast;

/// 625 times the matrix with these eigenvalues along axes that 3-4-5 angles turn: exact for small integers.
constexpr std::array<Vector, 3> turned_axes{Vector{15, 20, 0}, Vector{-12, 9, 20}, Vector{16, -12, 15}};

std::array<double, 6> matrix_of(const std::array<double, 3>& value) {
  std::array<double, 6> m{};
  constexpr std::array<std::array<std::size_t, 2>, 6> place{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  for (std::size_t k = 0; k < 6; ++k) {
    for (std::size_t i = 0; i < 3; ++i) m[k] += value[i] * turned_axes[i][place[k][0]] * turned_axes[i][place[k][1]];
  }
  return m;
}

double sine_between(Vector a, Vector b) { return length(cross(normalised(a), normalised(b))); }

}  // namespace

TEST_CASE("Eigenvalues and axes of a matrix are within their bounds, and the bounds are small") {
  const SymmetricEigen e = symmetric_eigen(matrix_of({1, 2, 5}));
  CHECK(e.value_error > 0);
  CHECK(e.value_error < 1e-12 * 3125);
  const std::array<double, 3> known{625, 1250, 3125};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::fabs(e.value[i] - known[i]) <= e.value_error);
    CHECK(sine_between(e.axis[i], turned_axes[i]) <= e.angle[i] + 1e-15);
    CHECK(e.angle[i] < 1e-12);
  }
  CHECK(dot(cross(e.axis[0], e.axis[1]), e.axis[2]) == Approx(1).epsilon(1e-14));
}

TEST_CASE("A diagonal matrix without error has exact eigenvalues and no bound to speak of") {
  const SymmetricEigen e = symmetric_eigen({7, -2, 3, 0, 0, 0});
  CHECK(e.value == std::array<double, 3>{-2, 3, 7});
  CHECK(e.value_error == 0);
  CHECK(e.angle == std::array<double, 3>{0, 0, 0});
  CHECK(e.axis[0] == Vector{0, 1, 0});
}

TEST_CASE("Axes of equal eigenvalues are undetermined, the third one is not") {
  const SymmetricEigen e = symmetric_eigen(matrix_of({1, 2, 2}), 1e-9);
  CHECK(e.angle[0] < 1e-10);
  CHECK(std::isinf(e.angle[1]));
  CHECK(std::isinf(e.angle[2]));
  CHECK(sine_between(e.axis[0], turned_axes[0]) <= e.angle[0]);
  for (const double angle : symmetric_eigen({3, 3, 3, 0, 0, 0}).angle) CHECK(std::isinf(angle));
}

TEST_CASE("Eigenvalues that differ by less than the error of the entries leave their axes undetermined") {
  CHECK(std::isinf(symmetric_eigen({1, 2, 3, 0, 0, 0}, 0.2).angle[0]));
  CHECK(symmetric_eigen({1, 2, 3, 0, 0, 0}, 0.1).angle[0] < 1);
}

TEST_CASE("The bounds hold for every matrix whose entries are within the error") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double tightest = 0;
  for (int i = 0; i < 2000; ++i) {
    const double error = std::exp2(-30 * std::fabs(uniform(random)));
    std::array<double, 6> near = matrix_of({uniform(random), uniform(random), uniform(random)});
    std::array<double, 6> truth = near;
    for (double& entry : truth) entry += error * (uniform(random) > 0 ? 1 : -1);
    const SymmetricEigen told = symmetric_eigen(near, error);
    const SymmetricEigen known = symmetric_eigen(truth);
    for (std::size_t k = 0; k < 3; ++k) {
      const double off = std::fabs(told.value[k] - known.value[k]);
      CHECK(off <= told.value_error + known.value_error);
      tightest = std::max(tightest, off / told.value_error);
      if (std::isfinite(told.angle[k]))
        CHECK(sine_between(told.axis[k], known.axis[k]) <= told.angle[k] + known.angle[k] + 1e-15);
    }
  }
  CHECK(tightest > 0.5);  // the bound is not far too wide
}

TEST_CASE("Matrices of any magnitude, and of none, have bounds") {
  for (const double size : {1e-300, 1e300}) {
    const SymmetricEigen e = symmetric_eigen({size, 2 * size, 3 * size, 0, 0, size / 2});
    CHECK(e.value[0] == size);
    CHECK(e.value_error < 1e-14 * size);
  }
  const SymmetricEigen zero = symmetric_eigen({});
  CHECK(zero.value == std::array<double, 3>{});
  CHECK(zero.value_error == 0);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const SymmetricEigen& e : {symmetric_eigen({infinity, 0, 0, 0, 0, 0}), symmetric_eigen({}, infinity)}) {
    CHECK(std::isnan(e.value[0]));
    CHECK(std::isinf(e.value_error));
    CHECK(std::isinf(e.angle[2]));
  }
}
