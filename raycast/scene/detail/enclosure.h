// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// By surface, a bit for each side (1 << Sense): Scene::leads_away. Empty if no side of any surface does. Found from
/// the tree and from exact forms, boxes helping where unions join what has no surface in common; a side may be missed,
/// none is told wrongly. Cost: of the order of the half-spaces of leaves that no operator subtracts.
std::vector<std::uint8_t> sides_that_lead_away(const Scene& scene);

}  // namespace csgcast::detail
