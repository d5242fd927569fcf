// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "measure/sheet/moments.h"
#include "measure/sheet/piece_forms.h"
#include "raycast/cells/pieces.h"

namespace csgcast::detail {

/// The contribution of a piece to a solid's measures, in the coordinates of its space.
struct Estimate {
  Moments moments;          ///< moments about the origin
  double volume_error = 0;  ///< error bound
  double area = 0;
  double area_error = 0;
  Vector reach;           ///< no coordinate of a wrongly counted point is greater in magnitude
  std::size_t split = 0;  ///< the axis across which the piece should be cut
};

Estimate estimate(const Space& space, const Piece& piece);

/// An estimate by sheets over one of the axes (docs/measuring.md). Returns nothing if the piece is not suitable, or if
/// the rule does not suit the surfaces. `split` is not set.
std::optional<Estimate> sheet_estimate(const PieceForms& forms);

/// An estimate with every surface replaced by a plane.
Estimate linear_estimate(const PieceForms& forms);

}  // namespace csgcast::detail
