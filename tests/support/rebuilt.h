// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "csg/solid/solid.h"

namespace csgcast::test {

/// A node like another over other children, as many; a leaf is itself.
Solid rebuilt(const Solid& solid, std::vector<Solid> children);

}  // namespace csgcast::test
