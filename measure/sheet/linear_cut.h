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

/// What planes cut out of a box about the origin.
struct LinearCut {
  Moments moments;                                   ///< of the points inside
  std::array<double, Piece::most_surfaces> areas{};  ///< of the faces in each plane: where the value changes across it
  std::size_t tetrahedra = 0;                        ///< that were summed
  std::size_t triangles = 0;
};

/// `table`: whether points are inside, by the signs of the forms (Piece::table). The sums are exact but for rounding
/// (docs/measuring.md).
LinearCut cut_linearly(std::span<const LinearForm> forms, const TruthTable& table, Vector half);

}  // namespace csgcast::detail
