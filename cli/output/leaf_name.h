// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>

#include "raycast/scene/scene.h"

namespace csgcast::cli {

/// `sphere at 3:5`.
inline std::string leaf_name(const Scene& scene, LeafId id) {
  const Leaf& leaf = scene.leaf(id);
  return fmt::format("{} at {}:{}", word(leaf.kind), leaf.place.line, leaf.place.column);
}

}  // namespace csgcast::cli
