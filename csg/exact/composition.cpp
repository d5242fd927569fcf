// SPDX-License-Identifier: MIT
#include "csg/exact/composition.h"

#include <algorithm>
#include <cmath>

#include "csg/base/precondition.h"
#include "csg/exact/affine.h"

namespace csgcast {
namespace {

/// How far an entry of a linear part may be off: half an ulp of its own, and the transform's error.
double error_of(const Transform& t, std::size_t row, std::size_t column) {
  return t.linear_error + 0x1p-53 * std::fabs(t(row, column));
}

}  // namespace

Transform operator*(const Transform& outer, const Transform& inner) {
  CSGCAST_PRECONDITION(outer.is_finite() && inner.is_finite());
  const ExactAffine exact = ExactAffine(outer) * ExactAffine(inner);
  Transform product;
  double most = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    product.entry[4 * row + 3] = exact.offset(row).nearest();
    for (std::size_t column = 0; column < 3; ++column) {
      product.entry[4 * row + column] = exact.linear(row, column).nearest();
      double error = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double a = error_of(outer, row, k), b = error_of(inner, k, column);
        error += std::fabs(outer(row, k)) * b + std::fabs(inner(k, column)) * a + a * b;
      }
      most = std::max(most, error);
    }
  }
  product.linear_error = most * (1 + 0x1p-48);  // the roundings of this sum
  return product;
}

}  // namespace csgcast
