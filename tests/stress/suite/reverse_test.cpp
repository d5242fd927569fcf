// SPDX-License-Identifier: MIT
#include "tests/stress/families.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/mirrored.h"

using namespace csgcast;

TEST_CASE("a hard ray and its reverse give mirrored lists, leaf by leaf, in every family") {
  const int trials = test::long_run() ? 1000 : 8;
  for (const stress::Family& family : stress::families()) {
    test::RandomSolids random(41);
    int wrong = 0;
    for (int n = 0; n < trials; ++n) {
      const stress::Trial trial = family.make(random, 50);
      const Scene scene = compile(trial.solid);
      Caster caster(scene);
      for (const Ray& ray : trial.rays) wrong += !test::mirrors(caster, ray);
    }
    CAPTURE(family.name);
    CHECK(wrong == 0);
  }
}
