// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// Tells which sides of a scene's surfaces lead away from the solid (Scene::leads_away). The result has a bit for each
/// side, 1 << Sense, by surface. It is empty if no side of any surface leads away. Only the scene's tables are used.
///
/// A side may be missed, but none is reported wrongly. The tree and the exact forms decide, and boxes help where a
/// union joins operands without a common surface. The cost is of the order of the number of half-spaces of leaves that
/// no operator subtracts.
std::vector<std::uint8_t> sides_that_lead_away(const Scene& scene);

}  // namespace csgcast::detail
