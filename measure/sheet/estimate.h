// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "measure/sheet/moments.h"
#include "measure/sheet/piece_forms.h"
#include "raycast/cells/pieces.h"

namespace csgcast::detail {

/// What a piece adds to a solid's measures, in the coordinates of its space.
struct Estimate {
  Moments moments;          ///< about the origin
  double volume_error = 0;  ///< a bound
  double area = 0;
  double area_error = 0;
  Vector reach;           ///< no point counted wrongly has a coordinate of greater magnitude
  std::size_t split = 0;  ///< the axis across which to cut the piece
};

Estimate estimate(const Space& space, const Piece& piece);

/// By sheets over one of the axes (docs/measuring.md); nothing if the piece is not like that, or rule and surfaces do
/// not go together. `split` is left open.
std::optional<Estimate> sheet_estimate(const PieceForms& forms);

/// The same with every surface replaced by a plane.
Estimate linear_estimate(const PieceForms& forms);

}  // namespace csgcast::detail
