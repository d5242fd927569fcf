// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "csg/base/vector.h"

namespace csgcast {

/// Eigenvalues and axes of a symmetric 3 x 3 matrix, each with a bound that is proved.
///
/// The bounds hold whatever the solver rounds: the residual is computed exactly. Of a matrix with an entry or an error
/// that is not finite, values are none and bounds are infinite.
struct SymmetricEigen {
  std::array<double, 3> value{};  ///< ascending
  double value_error = 0;         ///< of each: true eigenvalues, in ascending order, are within it (Weyl)
  /// The axis of each value, unit to a few 2^-53, right-handed; the longest component of the first two is positive.
  std::array<Vector, 3> axis{};
  /// Radians between each axis and the true one, as lines: at most (Davis and Kahan). Infinite: undetermined, as
  /// another eigenvalue may be the same or comes too near.
  std::array<double, 3> angle{};
};

/// `matrix`: xx, yy, zz, xy, xz, yz. The true entries are each within entry_error of those.
SymmetricEigen symmetric_eigen(const std::array<double, 6>& matrix, double entry_error = 0);

}  // namespace csgcast
