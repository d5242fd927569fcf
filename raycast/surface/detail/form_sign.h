// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/surface/surface.h"

namespace csgcast::detail {

/// The sign of a surface's form at a point. Double decides it where its error bound allows that, exact arithmetic
/// elsewhere.
int form_sign_at(const Surface& surface, Point p);

}  // namespace csgcast::detail
