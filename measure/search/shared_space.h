// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "csg/base/vector.h"
#include "measure/sheet/measures.h"
#include "raycast/cells/pieces.h"

namespace csgcast::detail {

/// The result of a search in a part of space.
struct SearchResult {
  std::optional<Point> witness;  ///< a place in the space
  bool is_empty = false;         ///< true if the space is proved to be empty
  double most_volume = 0;        ///< without a witness: upper bound on the volume that is left, in the scene's unit
};

/// Returns a place that is certainly in the space, on a line through a point of the scene, if it finds one there.
using LineTest = std::function<std::optional<Point>(Point through, Vector along)>;

/// Looks for a place in a space. Pieces that are likely to hold one come first. Very small pieces, for example along
/// faces that nearly coincide, are left to lines. Precondition: the space is bounded.
SearchResult find_place(const Space& space, const LineTest& test);

/// True if a space is proved to hold nothing. Only its pieces are used, down to the smallest.
bool is_nothing(const Space& space);

/// The volume, with an error of one per cent if possible. Precondition: the space is bounded.
Measured volume_of(const Space& space);

}  // namespace csgcast::detail
