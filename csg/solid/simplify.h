// SPDX-License-Identifier: MIT
#pragma once

#include "csg/solid/solid.h"

namespace csgcast {

/// An equal solid made of fewer nodes: the same point set, and the same parts, looks and leaves in the same order.
/// Nested unions and intersections are flattened, empty and full children absorbed, and double complements, identity
/// transforms and operators of one child removed.
Solid simplified(const Solid& solid);

}  // namespace csgcast
