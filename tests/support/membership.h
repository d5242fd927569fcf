// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "csg/exact/affine.h"
#include "csg/solid/solid.h"

namespace csgcast::test {

/// Whether a point is inside a solid, straight from its tree: every transform is undone on the point in homogeneous
/// exact coordinates, every leaf's own forms are evaluated there. Shares nothing with compilation. None if the point
/// lies exactly on the surface of some leaf.
std::optional<bool> contains(const Solid& solid, Point p);

}  // namespace csgcast::test
