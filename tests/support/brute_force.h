// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <gmpxx.h>

#include "raycast/line/ray.h"
#include "raycast/scene/scene.h"

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

/// The interval list of a scene of planes along the whole line, straight from the definition: all crossings of all
/// surfaces as fractions, sorted, ties grouped; the whole tree evaluated between groups; the tie rule tried on the
/// whole group. No culling, no merging, no filter.
std::vector<DefinedInterval> intervals_by_definition(const Scene& scene, const Ray& ray);

}  // namespace csgcast::test
