// SPDX-License-Identifier: MIT
#include "csg/exact/composition.h"

#include <array>
#include <cmath>

#include "csg/base/precondition.h"
#include "csg/exact/affine.h"

namespace csgcast {
Transform operator*(const Transform& outer, const Transform& inner) {
  CSGCAST_PRECONDITION(outer.is_finite() && inner.is_finite());
  const ExactAffine exact = ExactAffine(outer) * ExactAffine(inner);
  const std::array<double, 12> outer_errors = outer.errors(), inner_errors = inner.errors();
  constexpr double sum_roundings = 1 + 0x1p-48;
  Transform product;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      product.entry[4 * row + column] = (column < 3 ? exact.linear(row, column) : exact.offset(row)).nearest();
      double error = column < 3 ? 0 : outer_errors[4 * row + 3];
      for (std::size_t k = 0; k < 3; ++k) {
        const double a = outer_errors[4 * row + k], b = inner_errors[4 * k + column];
        error += std::fabs(outer(row, k)) * b + std::fabs(inner(k, column)) * a + a * b;
      }
      double& most = column < 3 ? product.linear_error : product.offset_error;
      most = std::fmax(most, error * sum_roundings);
    }
  }
  return product;
}

}  // namespace csgcast
