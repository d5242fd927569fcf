// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "raycast/surface/kind.h"

namespace csgcast {

using SurfaceKinds = std::span<const SurfaceKind* const>;

/// The table of kinds, the simplest first. A form becomes a surface of the first kind that takes it.
SurfaceKinds surface_kinds();

}  // namespace csgcast
