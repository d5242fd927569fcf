// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "csg/base/vector.h"
#include "measure/sheet/measures.h"
#include "raycast/cells/pieces.h"

namespace csgcast::detail {

/// What is known of a part of space after a search.
struct SearchResult {
  std::optional<Point> witness;  ///< a place in it
  bool is_empty = false;         ///< proved
  double most_volume = 0;        ///< without a witness: no more than this is left, in the scene's unit
};

/// A place that is surely in the space, on a line through a point of the scene, if one is found there.
using LineTest = std::function<std::optional<Point>(Point through, Vector along)>;

/// Looks for a place in a space, in pieces that are likely to hold one first. Precondition: it is bounded. Pieces of
/// next to nothing, as along faces that all but coincide, are left to lines.
SearchResult find_place(const Space& space, const LineTest& test);

/// Whether a space is proved to hold nothing: by its pieces alone, down to the least.
bool is_nothing(const Space& space);

/// The volume, to a hundredth if possible. Precondition: the space is bounded.
Measured volume_of(const Space& space);

}  // namespace csgcast::detail
