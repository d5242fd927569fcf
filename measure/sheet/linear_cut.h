// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "csg/base/vector.h"
#include "measure/sheet/moments.h"
#include "raycast/cells/pieces.h"

namespace csgcast::detail {

/// A function value + gradient . d.
struct LinearForm {
  double value = 0;
  Vector gradient;

  double at(Vector d) const { return value + dot(gradient, d); }
};

/// The part that planes cut out of a box about the origin.
struct LinearCut {
  Moments moments;                                   ///< moments of the points inside
  std::array<double, Piece::most_surfaces> areas{};  ///< by plane: the area of its faces
  std::size_t tetrahedra = 0;                        ///< the number of tetrahedra that were summed
  std::size_t triangles = 0;
};

/// `table` tells if points are inside, by the signs of the forms (Piece::table). The sums are exact up to rounding
/// (docs/measuring.md).
LinearCut cut_linearly(std::span<const LinearForm> forms, const TruthTable& table, Vector half);

}  // namespace csgcast::detail
