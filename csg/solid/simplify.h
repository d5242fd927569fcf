// SPDX-License-Identifier: MIT
#pragma once

#include "csg/solid/solid.h"

namespace csgcast {

/// The same point set, the same parts, looks and leaves in the same order, from fewer nodes: nested unions and
/// intersections flattened, empty and full children absorbed, double complements, identity transforms and operators of
/// one child removed.
Solid simplified(const Solid& solid);

}  // namespace csgcast
