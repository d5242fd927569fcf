// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "raycast/line/ray.h"

namespace csgcast::test {

/// One end of an interval of examples/flush.csg, from the geometry of that scene.
struct FlushEnd {
  double t = 0;
  /// The leaves, by their place in the file, that have a face there: one, or more where the place is within 1e-9 of an
  /// edge.
  std::vector<std::size_t> leaves;
};

/// What a ray sees of examples/flush.csg on its whole line, from the numbers of that scene: 6 x 6 unit bricks on the
/// half-space z <= 0, less six slots and 36 bores. All places where the ray may cross a face are computed and sorted;
/// between two of them it is in the solid if the point midway is. In long double, and in 500 bits if two of these
/// places are closer than 1e-9. Entry and exit in turn; infinite ends have no leaves. Shares nothing with the library.
std::vector<FlushEnd> flush_truth(const Ray& ray);

}  // namespace csgcast::test
