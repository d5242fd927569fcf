// SPDX-License-Identifier: MIT
#include <cmath>

#include "csg/solid/primitives.h"
#include "tests/stress/aimed_rays.h"
#include "tests/stress/family_lists.h"
#include "tests/stress/pieces.h"

namespace csgcast::stress {
namespace {

using test::RandomSolids;

Trial bisected(RandomSolids& random, int rays, Difference difference) {
  Trial trial{random.tree(3), {}};
  aim_by_bisection(random, trial, rays, difference);
  return trial;
}

Trial nearly_equal(RandomSolids& random, int rays) {
  Solid solid = sphere(1);
  for (int i = 0; i < 12; ++i) {
    const double off = power_of_tenth(random, 10, 17);
    const Solid next = at(sphere(1 + off), off * random.direction());
    solid = i % 3 == 0 ? solid + next : i % 3 == 1 ? solid - next : next - solid;
  }
  Trial trial{solid, {}};
  aim_at_middle(random, trial, rays);
  return trial;
}

// Sixty deep: every level adds or takes away the same box, cylinder or ball, a few ulps or a little off, or exactly.
Trial deep(RandomSolids& random, int rays) {
  const Vector size{random.number(0.5, 1.5), random.number(0.5, 1.5), random.number(0.5, 1.5)};
  const std::size_t kind = random.index(3);
  const auto nearly = [&] { return random.index(3) == 0 ? 0 : power_of_tenth(random, 8, 17); };
  Solid solid;
  for (int level = 0; level < 60; ++level) {
    const double off = nearly();
    const Vector now = (1 + off) * size;
    const Solid next = kind == 0   ? box(now, Centering::centered)
                       : kind == 1 ? cylinder(now.z, now.x, now.x, Centering::centered)
                                   : sphere(now.x);
    const Solid placed = at(next, nearly() * random.direction());
    solid = level % 3 == 0 ? solid + placed : level % 3 == 1 ? solid - placed : placed - solid;
  }
  Trial trial{solid + at(sphere(0.25), {0, 0, 1.5}), {}};
  aim_at_middle(random, trial, rays);
  return trial;
}

Trial random_placements(RandomSolids& random, int rays) {
  Trial trial{random.tree(9), {}};
  aim_at_middle(random, trial, rays);
  return trial;
}

Transform random_affine(RandomSolids& random) {
  Transform m;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column)
      m.entry[4 * row + column] = random.number(-1, 1) + (row == column ? 1.2 : 0);
    m.entry[4 * row + 3] = random.number(-1, 1);
  }
  return m;
}

// One shape under several nested affine maps, with mirrors and shears, each leaf under others.
Trial affine(RandomSolids& random, int rays) {
  const auto leaf = [&] {
    Solid solid = random.index(2) == 0 ? curved(random) : random.grid_box();
    solid = transformed(solid, random_affine(random));
    if (random.index(2) == 0) solid = transformed(solid, mirroring(random.direction()));
    return random.index(2) == 0 ? solid : transformed(solid, random_affine(random));
  };
  Trial trial{random.tree(5, leaf), {}};
  aim_at_middle(random, trial, rays / 2);
  aim_at_tangents(random, trial, rays / 4, power_of_tenth(random, 6, 16));
  aim_by_bisection(random, trial, rays / 4, Difference::surfaces);
  return trial;
}

}  // namespace

std::vector<Family> tree_families() {
  const auto onto = [](Difference difference) {
    return [=](RandomSolids& random, int rays) { return bisected(random, rays, difference); };
  };
  return {{"bisected onto edges", onto(Difference::surfaces)},
          {"bisected onto silhouettes", onto(Difference::intervals)},
          {"nearly equal solids", nearly_equal},
          {"nearly equal solids, 60 deep", deep},
          {"random placements", random_placements},
          {"mirrors and shears", affine}};
}

}  // namespace csgcast::stress
