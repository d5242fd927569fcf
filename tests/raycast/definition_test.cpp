// SPDX-License-Identifier: MIT
#include "csg/solid/primitives.h"
#include "raycast/ray/caster.h"
#include "tests/support/brute_force.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using test::grid_ray;
using test::RandomSolids;

namespace {

void compare(RandomSolids& random, const Solid& solid, int rays) {
  const Scene scene = compile(solid);
  Caster caster(scene);
  IntervalList list;
  for (int i = 0; i < rays; ++i) {
    const Ray ray = grid_ray(random);
    const auto defined = test::intervals_by_definition(scene, ray);
    caster.begin(ray);
    caster.intervals(list, Span::line());
    test::check_list(caster, list, defined);
  }
}

}  // namespace

TEST_CASE("grid boxes: lists, bounding surfaces and leaves are those of the definition, ties included") {
  RandomSolids random(11);
  for (int n = 0; n < test::times(300); ++n) {
    compare(random, random.tree(2 + n % 9, [&] { return random.grid_box(); }), 40);
  }
}

TEST_CASE("corner-sharing polyhedra: the same") {
  RandomSolids random(12);
  for (int n = 0; n < test::times(200); ++n) {
    compare(random,
            random.tree(2 + n % 5,
                        [&] {
                          std::vector<Point> points(6);
                          for (Point& p : points)
                            p = {random.quarter(-1, 1), random.quarter(-1, 1), random.quarter(-1, 1)};
                          return convex_from_points(points);
                        }),
            40);
  }
}

TEST_CASE("half-spaces and their complements: the same") {
  RandomSolids random(13);
  for (int n = 0; n < test::times(200); ++n) {
    compare(random,
            random.tree(2 + n % 6,
                        [&] {
                          Vector normal;
                          while (normal == Vector{})
                            normal = {random.quarter(-1, 1), random.quarter(-1, 1), random.quarter(-1, 1)};
                          const Solid half = halfspace(normal, random.quarter(-1, 1));
                          return random.index(3) == 0 ? complement(half) : half;
                        }),
            40);
  }
}
