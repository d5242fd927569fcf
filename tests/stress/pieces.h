// SPDX-License-Identifier: MIT
#pragma once

#include "csg/base/box.h"
#include "tests/stress/families.h"
#include "tests/support/at.h"

namespace csgcast::stress {

// What families are put together from.

using test::at;

Transform random_rotation(test::RandomSolids& random);
/// 10^-digits with digits anywhere in [least, most].
double power_of_tenth(test::RandomSolids& random, double least, double most);

/// A curved leaf of size about 1 about the origin.
Solid curved(test::RandomSolids& random);
/// One that is maybe turned and moved.
Solid placed_curved(test::RandomSolids& random);
/// Boxes on the grid of quarters within 2.5 of the origin, added and taken away, and where each is.
struct GridBoxes {
  Solid solid;
  std::vector<Box> boxes;
};
GridBoxes grid_boxes(test::RandomSolids& random, int count);

/// Adds a ray if its numbers are in range.
void add(Trial& trial, Point o, Vector d);
/// The whole trial turned at random about the origin; the rays' numbers are rounded.
Trial turned(test::RandomSolids& random, Trial trial);
/// The whole trial 2^exponent times as large, exactly.
Trial rescaled(Trial trial, int exponent);

}  // namespace csgcast::stress
