// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "raycast/line/twofold.h"
#include "raycast/surface/predicates.h"

// The second rung of the ladder: crossings in twofold arithmetic, for what plain double leaves open. docs/accuracy.md
// derives the bounds.

namespace csgcast::detail {

/// A crossing's tau with a bound on its error.
struct TwofoldRoot {
  Twofold tau;
  double error;
};

/// The crossings, if it is certain which exist. Precondition: the line does not depart from the surface.
std::optional<LineCrossings> twofold_crossings(const LineFrame& line, const Surface& surface);

/// The root of a crossing that is known to exist, if its error can be bounded. Precondition: the line does not depart
/// from the surface.
std::optional<TwofoldRoot> twofold_root(const LineFrame& line, const CrossingView& crossing);

/// The sign of a - b if it is certain, else 0.
int certain_order(const TwofoldRoot& a, const TwofoldRoot& b);

}  // namespace csgcast::detail
