// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "raycast/surface/line_crossings.h"

namespace csgcast::detail {

/// The correctly rounded t of a crossing with a surface that has a form of the second degree. It is found by one Newton
/// step on a residual in twofold arithmetic, or else from the twofold root. Returns nothing if the error bounds of both
/// leave the rounding open.  Source of the rounding test: Ziv 1991.
std::optional<double> nearest_t(const Line& line, const CrossingView& crossing);

}  // namespace csgcast::detail
