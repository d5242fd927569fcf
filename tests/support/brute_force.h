// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <gmpxx.h>

#include "raycast/line/ray.h"
#include "raycast/ray/caster.h"
#include "raycast/scene/scene.h"
#include "tests/support/random_solid.h"

namespace csgcast::test {

/// One end of an interval by the definition: the bounding surface and the leaf whose face it is; not valid at an
/// infinite end.
struct DefinedEnd {
  mpq_class t;
  SurfaceId surface;
  LeafId leaf;
};
struct DefinedInterval {
  DefinedEnd entry;
  DefinedEnd exit;
};

/// What a leaf with a function of its own is: whether a place is inside, by which of its half-spaces hold.
using DefinedLeaf = std::function<bool(const std::vector<bool>& holds)>;

/// The interval list of a scene of planes and products of planes (planted.h) along the whole line, straight from the
/// definition: all crossings of all surfaces as fractions, sorted, ties grouped; the whole tree evaluated between
/// groups; the tie rule tried on the whole group. No culling, no merging, no filter. Of a departure, which must start
/// exactly on its surface, the list is right from the start on.
std::vector<DefinedInterval> intervals_by_definition(const Scene& scene, const Ray& ray,
                                                     const DefinedLeaf& function_leaf = {},
                                                     const std::optional<Departure>& departure = {});

/// That a caster's list is this one, whose ends belong to these leaves.
void check_list(Caster& caster, const IntervalList& list, const std::vector<DefinedInterval>& defined);

/// Along the grid of quarters, through its points, edges and faces, and a few that miss all of them.
Ray grid_ray(RandomSolids& random);

}  // namespace csgcast::test
