// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "raycast/line/twofold.h"
#include "raycast/surface/predicates.h"

// The second rung of the ladder: crossings in twofold arithmetic, for what plain double leaves open. The bounds are
// derived in docs/accuracy.md.

namespace csgcast::detail {

/// A crossing's tau with a bound on its error.
struct TwofoldRoot {
  Twofold tau;
  double error;
};

/// Which crossings exist, if that is certain. Not for the surface that a line departs from.
std::optional<LineCrossings> twofold_crossings(const LineFrame& line, const Surface& surface);

/// A crossing that is known to exist. Not for the surface that a line departs from.
std::optional<TwofoldRoot> twofold_root(const LineFrame& line, const CrossingView& crossing);

/// The sign of a - b if it is certain, else 0.
int certain_order(const TwofoldRoot& a, const TwofoldRoot& b);

}  // namespace csgcast::detail
