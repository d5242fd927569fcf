// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "csg/base/transform.h"
#include "csg/base/vector.h"
#include "csg/exact/dyadic.h"

namespace csgcast {

/// A point with exact coordinates.
using ExactPoint = std::array<Dyadic, 3>;

/// A product of affine transforms, composed without rounding.
class ExactAffine {
 public:
  ExactAffine();  ///< the identity
  explicit ExactAffine(const Transform& transform);

  const Dyadic& linear(std::size_t row, std::size_t column) const { return linear_[3 * row + column]; }
  const Dyadic& offset(std::size_t row) const { return offset_[row]; }

  Dyadic determinant() const;
  bool is_singular() const { return determinant().is_zero(); }
  /// Entry (row, column) of the adjugate of the linear part: inverse times determinant.
  Dyadic adjugate(std::size_t row, std::size_t column) const;
  ExactPoint operator()(const ExactPoint& p) const;
  /// The largest number of bits of an entry. It tells the cost of an exact composition.
  std::size_t bits() const;

  /// The product: first `inner`, then `outer`.
  friend ExactAffine operator*(const ExactAffine& outer, const ExactAffine& inner);
  friend bool operator==(const ExactAffine&, const ExactAffine&) = default;

 private:
  std::array<Dyadic, 9> linear_;
  std::array<Dyadic, 3> offset_;
};

}  // namespace csgcast
