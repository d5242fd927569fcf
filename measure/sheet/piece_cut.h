// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>

#include "raycast/cells/pieces.h"

namespace csgcast::detail {

/// Cuts a piece, but not in the middle: faces are likely there, and a face along a cut belongs to neither side for
/// certain.
inline std::pair<Piece, Piece> cut_across(PieceCutter& cutter, const Piece& piece, std::size_t axis) {
  const double low = piece.box.lower[axis];
  return cutter.cut(piece, axis, low + 0.4887 * (piece.box.upper[axis] - low));
}

/// Cuts across the axis that leaves the fewest surfaces in the halves. `preferred` is used if it is as good as any
/// other.
inline std::pair<Piece, Piece> cut_apart(PieceCutter& cutter, const Piece& piece, std::size_t preferred) {
  const auto surfaces = [](const std::pair<Piece, Piece>& halves) { return halves.first.count + halves.second.count; };
  std::pair<Piece, Piece> best = cut_across(cutter, piece, preferred);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axis == preferred) continue;
    std::pair<Piece, Piece> other = cut_across(cutter, piece, axis);
    if (surfaces(other) < surfaces(best)) best = std::move(other);
  }
  return best;
}

}  // namespace csgcast::detail
