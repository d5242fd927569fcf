// SPDX-License-Identifier: MIT
#include "raycast/ray.h"

#include "csg/error.h"

namespace csgcast {

Ray::Ray(Point origin, Vector direction) : origin_(origin), direction_(direction) {
  if (!is_finite(origin) || !is_finite(direction)) {
    throw Error(ErrorCode::bad_value, {}, "a ray needs six finite numbers",
                "an infinite or undefined ray meets nothing", "check its origin and direction");
  }
  if (direction == Vector{}) {
    throw Error(ErrorCode::bad_value, {}, "a ray's direction is zero", "it does not say where to look",
                "give any non-zero direction");
  }
}

}  // namespace csgcast
