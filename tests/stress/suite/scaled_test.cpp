// SPDX-License-Identifier: MIT
#include <cmath>

#include "tests/stress/families.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/twins.h"

using namespace csgcast;

namespace {

// Rays that do not get the same answers from a scene 2^k times as large; none if the trial is out of range there.
int wrong_when_scaled(const stress::Trial& trial, int k, int& compared) {
  const double factor = std::exp2(k);
  const Scene scene = compile(trial.solid);
  const Scene large = compile(test::scaled(trial.solid, factor));
  test::Twins twins(scene, large, factor);
  int wrong = 0;
  for (const Ray& ray : trial.rays) {
    if (!Ray::in_range(test::scaled(ray.origin(), factor), factor * ray.direction())) continue;
    wrong += !twins.agree(ray, compared % 2 == 0);
    ++compared;
  }
  return wrong + !twins.worked_alike();
}

}  // namespace

TEST_CASE("hard rays of a scene 2^k times as large get the same answers, t scaled exactly, in every family") {
  const int trials = test::long_run() ? 200 : 4;
  for (const stress::Family& family : stress::families()) {
    test::RandomSolids random(42);
    int wrong = 0, compared = 0;
    for (int n = 0; n < trials; ++n) {
      const stress::Trial trial = family.make(random, 50);
      for (const int k : {-9, 1, 7}) wrong += wrong_when_scaled(trial, k, compared);
    }
    CAPTURE(family.name);
    CHECK(wrong == 0);
    CHECK(compared > 50 * trials);
  }
}
