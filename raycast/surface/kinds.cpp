// SPDX-License-Identifier: MIT
#include "raycast/surface/kinds.h"

#include <array>

namespace csgcast {

SurfaceKinds surface_kinds() {
  static constexpr std::array table{&plane_kind, &quadric_kind};
  return table;
}

}  // namespace csgcast
