// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/scene/scene.h"
#include "raycast/surface/kinds.h"

namespace csgcast::detail {

/// csgcast::compile() with a given table of kinds. Precondition: for each form of the solid, the table has a kind that
/// takes it.
Scene compile(Solid solid, const Welding& welding, SurfaceKinds kinds);

}  // namespace csgcast::detail
