// SPDX-License-Identifier: MIT
#pragma once

#include "csg/solid/solid.h"

namespace csgcast::test {

/// The image of a point, rounded.
Point image(const Transform& transform, Point p);

/// The solid moved, with one transform above each leaf: the product of all those above it, rounded to doubles. So faces
/// that coincided do so but for that rounding. Looks and parts are kept.
Solid with_rounded_leaves(const Solid& solid, const Transform& world_from_solid);

}  // namespace csgcast::test
