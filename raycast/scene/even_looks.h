// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "raycast/scene/scene.h"

namespace csgcast {

/// For each region: 1 if it looks the same everywhere, that is, all leaves that nothing subtracts have the region's
/// look; else 0.
inline std::vector<std::uint8_t> even_looks(const Scene& scene) {
  std::vector<std::uint8_t> even(scene.regions().size(), 1);
  for (const Leaf& leaf : scene.leaves()) {
    if (leaf.region.valid() && !leaf.holds_nothing && leaf.look != scene.region(leaf.region).look)
      even[leaf.region.index()] = 0;
  }
  return even;
}

}  // namespace csgcast
