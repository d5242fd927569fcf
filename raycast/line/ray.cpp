// SPDX-License-Identifier: MIT
#include "raycast/line/ray.h"

#include "csg/base/error.h"
#include "csg/base/length.h"

namespace csgcast {
bool Ray::in_range(Point origin, Vector direction) {
  const double length = longest(direction);
  return longest(as_vector(origin)) <= greatest && length <= greatest && length >= least_direction;
}

Ray::Ray(Point origin, Vector direction) : origin_(origin), direction_(direction) {
  if (!is_finite(origin) || !is_finite(direction)) {
    throw Error(ErrorCode::bad_value, {}, "a ray needs six finite numbers",
                "an infinite or undefined ray meets nothing", "check its origin and direction");
  }
  if (direction != Vector{} && !in_range(origin, direction)) {
    throw Error(ErrorCode::limit, {}, "a ray's origin or direction is out of range",
                "coordinates up to 2^400 and directions from 2^-400 to 2^400 work", "choose another unit of length");
  }
  if (direction == Vector{}) {
    throw Error(ErrorCode::bad_value, {}, "a ray's direction is zero", "it does not say where to look",
                "give any non-zero direction");
  }
}

}  // namespace csgcast
