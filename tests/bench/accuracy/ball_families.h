// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tests/stress/families.h"

namespace csgcast::bench {

/// Families of balls whose numbers, and those of their rays, are single-precision floats: so that programs in single
/// precision are asked about the very same scene.
std::span<const stress::Family> ball_families();

struct Ball {
  Point center;
  double radius;
};

/// The balls of a union of moved spheres, if the solid is one and all its numbers are floats.
std::optional<std::vector<Ball>> balls_of(const Solid& solid);

}  // namespace csgcast::bench
