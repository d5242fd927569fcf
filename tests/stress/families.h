// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "csg/solid/solid.h"
#include "raycast/line/ray.h"
#include "tests/support/random_solid.h"

namespace csgcast::stress {

/// One scene of a family with the rays that make it hard.
struct Trial {
  Solid solid;
  std::vector<Ray> rays;
};

/// A way to be hard: makes a trial of about `rays` rays from a seeded source, the same everywhere. Each is where plain
/// floating point goes wrong.
struct Family {
  std::string name;
  std::function<Trial(test::RandomSolids& random, int rays)> make;
};

/// All of them; their names differ.
std::span<const Family> families();

}  // namespace csgcast::stress
