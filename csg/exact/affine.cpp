// SPDX-License-Identifier: MIT
#include "csg/exact/affine.h"

#include <algorithm>

namespace csgcast {

ExactAffine::ExactAffine() {
  for (std::size_t i = 0; i < 3; ++i) linear_[4 * i] = Dyadic(1.0);
}

ExactAffine::ExactAffine(const Transform& transform) {
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) linear_[3 * row + column] = Dyadic(transform(row, column));
    offset_[row] = Dyadic(transform(row, 3));
  }
}

Dyadic ExactAffine::adjugate(std::size_t row, std::size_t column) const {
  // The cofactor of (column, row); with cyclic indices no sign is needed.
  const std::size_t r1 = (column + 1) % 3;
  const std::size_t r2 = (column + 2) % 3;
  const std::size_t c1 = (row + 1) % 3;
  const std::size_t c2 = (row + 2) % 3;
  return linear(r1, c1) * linear(r2, c2) - linear(r1, c2) * linear(r2, c1);
}

Dyadic ExactAffine::determinant() const {
  Dyadic sum;
  for (std::size_t i = 0; i < 3; ++i) sum += linear(0, i) * adjugate(i, 0);
  return sum;
}

ExactPoint ExactAffine::operator()(const ExactPoint& p) const {
  ExactPoint image;
  for (std::size_t row = 0; row < 3; ++row) {
    image[row] = offset_[row];
    for (std::size_t column = 0; column < 3; ++column) image[row] += linear(row, column) * p[column];
  }
  return image;
}

std::size_t ExactAffine::bits() const {
  std::size_t most = 0;
  for (const Dyadic& entry : linear_) most = std::max(most, entry.bits());
  for (const Dyadic& entry : offset_) most = std::max(most, entry.bits());
  return most;
}

ExactAffine operator*(const ExactAffine& outer, const ExactAffine& inner) {
  ExactAffine product;
  for (std::size_t row = 0; row < 3; ++row) {
    product.offset_[row] = outer.offset_[row];
    for (std::size_t k = 0; k < 3; ++k) product.offset_[row] += outer.linear(row, k) * inner.offset_[k];
    for (std::size_t column = 0; column < 3; ++column) {
      Dyadic sum;
      for (std::size_t k = 0; k < 3; ++k) sum += outer.linear(row, k) * inner.linear(k, column);
      product.linear_[3 * row + column] = std::move(sum);
    }
  }
  return product;
}

}  // namespace csgcast
