// SPDX-License-Identifier: MIT
// A ray and its reverse see the same, from the other end.
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/examples.h"
#include "tests/support/mirrored.h"
#include "tests/support/scene_rays.h"

using namespace csgcast;

namespace {

int not_mirrored(const Scene& scene, std::uint64_t seed, int rays) {
  Caster caster(scene);
  test::SceneRays source(scene, seed);
  int wrong = 0;
  for (int i = 0; i < rays; ++i) wrong += !test::mirrors(caster, source.next());
  return wrong;
}

}  // namespace

TEST_CASE("a ray through an example scene and its reverse give mirrored lists, leaf by leaf") {
  for (const std::string& name : test::example_names()) {
    CAPTURE(name);
    CHECK(not_mirrored(compile(test::example(name).solid), 31, test::long_run() ? 1'000'000 : test::times(5000)) == 0);
  }
}

TEST_CASE("a ray through a random solid and its reverse give mirrored lists, leaf by leaf") {
  const int solids = test::long_run() ? 20'000 : test::times(400);
  test::RandomSolids random(32);
  int wrong = 0;
  for (int n = 0; n < solids; ++n) {
    const Solid tree = random.tree(10, [&] { return n % 3 != 0 ? random.leaf() : random.grid_box(); });
    wrong += not_mirrored(compile(tree), random.index(1'000'000), 100);
  }
  CHECK(wrong == 0);
}
