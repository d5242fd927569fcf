// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "raycast/surface/line_crossings.h"

namespace csgcast::detail {

/// The t of a crossing with a surface that is given by a form of the second degree, correctly rounded: one Newton step
/// on a residual in twofold arithmetic, else the twofold root. Nothing where the error bounds of both leave the
/// rounding open.  Source of the rounding test: Ziv 1991.
std::optional<double> nearest_t(const Line& line, const CrossingView& crossing);

}  // namespace csgcast::detail
