// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// Which sides of a scene's surfaces lead away from the solid (Scene::leads_away): for each surface a bit for each
/// side, 1 << Sense. Empty if no side of any surface does. Looks at the scene's tables only.
///
/// A side may be missed, but none is told wrongly. The tree and the exact forms tell, and boxes help where unions join
/// what has no surface in common. The cost is of the order of the half-spaces of leaves that no operator subtracts.
std::vector<std::uint8_t> sides_that_lead_away(const Scene& scene);

}  // namespace csgcast::detail
