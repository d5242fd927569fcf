// SPDX-License-Identifier: MIT
#include "raycast/ray/part_overlaps.h"

#include <algorithm>
#include <string>

#include "raycast/line/interval_list.h"
#include "tests/support/catch.h"
#include "tests/support/random_solid.h"
#include "tests/support/scene_rays.h"

using namespace csgcast;

namespace {

// What the two parts' lists have in common, pair by pair.
std::vector<PartOverlap> pair_by_pair(Caster& caster, Span span) {
  const std::span<const Part> parts = caster.scene().parts();
  std::vector<IntervalList> lists(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) caster.intervals(parts[i].node, lists[i], span);
  std::vector<PartOverlap> overlaps;
  IntervalList common;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    for (std::uint32_t j = i + 1; j < parts.size(); ++j) {
      combine<Intersection>(lists[i], lists[j], common,
                            [&](const Crossing& a, const Crossing& b) { return caster.order(a, b); });
      for (const Interval& interval : common) overlaps.push_back({PartId(i), PartId(j), interval});
    }
  }
  std::ranges::stable_sort(overlaps, [&](const PartOverlap& a, const PartOverlap& b) {
    return caster.order(a.common.exit, b.common.exit) < 0;
  });
  return overlaps;
}

// Ends that tie may be told by either surface.
bool agree(Caster& caster, const PartOverlap& a, const PartOverlap& b) {
  return a.first == b.first && a.second == b.second && caster.order(a.common.entry, b.common.entry) == 0 &&
         caster.order(a.common.exit, b.common.exit) == 0;
}

}  // namespace

TEST_CASE("overlaps on a ray are what the parts' lists have in common, pair by pair") {
  std::uint64_t found = 0, ties = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    test::RandomSolids random(seed);
    std::vector<Solid> parts;
    for (int i = 0; i < 6; ++i) {
      Solid solid = seed % 2 == 0 ? random.tree(3) : random.tree(3, [&] { return random.grid_box(); });
      parts.push_back(named(std::move(solid), {"part " + std::to_string(i), 1}));
    }
    const Scene scene = compile(unite(std::move(parts)));
    Caster caster(scene);
    PartOverlaps overlaps;
    std::vector<PartOverlap> list;
    test::SceneRays rays(scene, seed);
    for (int i = 0; i < 200; ++i) {
      const Span span = i % 3 == 0 ? Span::line() : i % 3 == 1 ? Span{} : Span{0.25, 1.5};
      caster.begin(rays.next());
      const std::uint64_t count = overlaps.find(caster, span, 1000, list);
      const std::vector<PartOverlap> expected = pair_by_pair(caster, span);
      REQUIRE(count == expected.size());
      REQUIRE(list.size() == expected.size());
      for (const PartOverlap& overlap : expected) {
        const auto same = std::ranges::count_if(list, [&](const PartOverlap& l) { return agree(caster, l, overlap); });
        REQUIRE(same == 1);
      }
      for (std::size_t k = 1; k < list.size(); ++k) {
        const auto side = caster.order(list[k - 1].common.exit, list[k].common.exit);
        REQUIRE(!(side > 0));
        ties += side == 0;
      }
      found += count;
      if (count < 2) continue;
      REQUIRE(overlaps.find(caster, span, 1, list) == count);
      REQUIRE(list.size() == 1);
    }
  }
  CHECK(found > 5000);
  CHECK(ties > 100);
}
