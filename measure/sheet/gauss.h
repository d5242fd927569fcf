// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace csgcast::detail {

/// Gauss's rule on [-1, 1], and its error.
struct Gauss {
  static constexpr std::size_t points = 6;
  static constexpr std::array<double, points> node{-0.932469514203152027812301554494, -0.661209386466264513661399595020,
                                                   -0.238619186083196908630501721681, 0.238619186083196908630501721681,
                                                   0.661209386466264513661399595020,  0.932469514203152027812301554494};
  static constexpr std::array<double, points> weight{
      0.171324492379170345040296142173, 0.360761573048138607569833513838, 0.467913934572691047389870343990,
      0.467913934572691047389870343990, 0.360761573048138607569833513838, 0.171324492379170345040296142173};

  /// Error bound for a function that is analytic and at most 1 in magnitude in the ellipse with foci -1 and 1 whose
  /// semi-axes add up to rho. Its Chebyshev coefficients are at most 2 rho^-k (Trefethen, Approximation Theory and
  /// Approximation Practice, theorem 8.1), and the rule is exact up to degree 2 points - 1.
  static double error(double rho) { return 64.0 / 15 * std::pow(rho, -2.0 * points) / (1 - 1 / (rho * rho)); }
  /// The radius of a disc that contains the ellipse.
  static double reach(double rho) { return 0.5 * (rho + 1 / rho); }
  /// The sums of semi-axes that are tried.
  static constexpr std::array<double, 6> ellipses{12, 7, 4.5, 3, 2.2, 1.7};
};

}  // namespace csgcast::detail
