// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>

#include "cli/output/camera_text.h"
#include "raycast/scene/scene.h"

namespace csgcast::cli {

/// `is open towards 0, 0, 1 (3:1)`, with the place of a statement; or `may be open ..`. Of a solid that is bounded
/// `may be unbounded`, as a part of it may be.
inline std::string opening_text(const Scene& scene) {
  const std::optional<Opening>& opening = scene.opening();
  if (!opening || opening->direction == Vector{}) return "may be unbounded";
  const std::string place =
      opening->place.line > 0 ? fmt::format(" ({}:{})", opening->place.line, opening->place.column) : std::string();
  return fmt::format("{} open towards {}{}", opening->is_certain ? "is" : "may be", coordinates(opening->direction),
                     place);
}

}  // namespace csgcast::cli
