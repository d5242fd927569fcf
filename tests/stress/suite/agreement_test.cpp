// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdlib>
#include <string_view>

#include "raycast/caster.h"
#include "tests/stress/families.h"
#include "tests/support/catch.h"

using namespace csgcast;

namespace {

// CSGCAST_LONG=1 asks for a million rays a family.
std::uint64_t rays_a_family() {
  const char* variable = std::getenv("CSGCAST_LONG");
  return variable != nullptr && std::string_view(variable) == "1" ? 1'000'000 : 4'000;
}

// Roots are numbered among those that matter on the line: floating point may leave out one that is out of the scene's
// reach.
bool same(const Crossing& a, const Crossing& b) { return a.surface == b.surface && a.t == b.t; }

bool same(const IntervalList& a, const IntervalList& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Interval& i, const Interval& j) {
    return same(i.entry, j.entry) && same(i.exit, j.exit);
  });
}

struct Tally {
  std::uint64_t rays = 0;
  std::uint64_t intervals = 0;
  std::uint64_t flagged = 0;
  std::uint64_t wrong = 0;
  std::string first;
};

void compare(const stress::Trial& trial, std::uint64_t seed, Tally& tally) {
  const Scene scene = compile(trial.solid);
  Caster certified(scene);
  Caster exact(scene, exact_predicates());
  IntervalList list;
  IntervalList expected;
  for (const Ray& ray : trial.rays) {
    for (const Span span : {Span::line(), Span{}}) {
      certified.begin(ray);
      exact.begin(ray);
      certified.intervals(list, span);
      exact.intervals(expected, span);
      ++tally.rays;
      tally.intervals += expected.size();
      if (same(list, expected)) continue;
      if (++tally.wrong > 1) continue;
      tally.first = fmt::format("seed {}: ray ({:a}, {:a}, {:a}) + t ({:a}, {:a}, {:a}), from {}: {} intervals, not {}",
                                seed, ray.origin().x, ray.origin().y, ray.origin().z, ray.direction().x,
                                ray.direction().y, ray.direction().z, span.from, list.size(), expected.size());
    }
  }
  tally.flagged += certified.counts().rays_flagged;
}

}  // namespace

TEST_CASE("certified lists are those of exact arithmetic, surface by surface and bit by bit, in every family") {
  for (const stress::Family& family : stress::families()) {
    Tally tally;
    for (std::uint64_t seed = 1; tally.rays < rays_a_family(); ++seed) {
      test::RandomSolids random(seed);
      compare(family.make(random, 50), seed, tally);
    }
    WARN(fmt::format("{:32} {:8} rays {:8} intervals, {:8} flagged, {} wrong", family.name, tally.rays, tally.intervals,
                     tally.flagged, tally.wrong));
    INFO(tally.first);
    CHECK(tally.wrong == 0);
    CHECK(tally.intervals > tally.rays / 20);
  }
}
