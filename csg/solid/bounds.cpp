// SPDX-License-Identifier: MIT
#include "csg/solid/bounds.h"

#include "csg/solid/detail/bounds_walk.h"

namespace csgcast {

Box bounds(const Solid& solid) { return detail::BoundsWalk().bounds_of(solid); }

}  // namespace csgcast
