// SPDX-License-Identifier: MIT
#include "measure/check.h"

#include <cmath>

#include "csg/primitives.h"
#include "raycast/caster.h"
#include "tests/support/catch.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using test::RandomSolids;

namespace {

Solid shifted(Solid solid, Vector by) { return transformed(std::move(solid), translation(by)); }
Solid part(const char* name, Solid solid) { return named(std::move(solid), {name, 1}); }

/// Two parts of size about 1 that overlap by `depth`; with 0 they are flush: faces coincide, or touch in a line or a
/// point. `kind` in [0, 10).
std::pair<Solid, Solid> pair_of(int kind, double depth) {
  const Centering centered = Centering::centered;
  switch (kind) {
    case 0:  // side by side
      return {box({1, 1, 1}), shifted(box({1, 0.5, 0.75}), {1 - depth, 0.25, 0.125})};
    case 1:  // a peg in its hole
      return {box({2, 2, 1}, centered) - cylinder(4, 0.5, 0.5, centered),
              cylinder(3, 0.5 + depth, 0.5 + depth, centered)};
    case 2:  // a ball on a plate
      return {box({2, 2, 0.5}), shifted(sphere(0.5), {1, 1, 1 - depth})};
    case 3:  // a ball in its socket
      return {box({2, 2, 2}, centered) - sphere(0.75), sphere(0.75 + depth)};
    case 4:  // two balls
      return {sphere(0.5), shifted(sphere(0.5), {1 - depth, 0, 0})};
    case 5:  // a cone in its seat
      return {shifted(box({2, 2, 1}), {-1, -1, 0}) - cylinder(1, 0.25, 0.75),
              shifted(cylinder(1, 0.25, 0.75), {0, 0, -depth})};
    case 6:  // edge to edge
      return {box({1, 1, 1}), shifted(box({1, 1, 1}), {1 - depth, 1 - depth, 0})};
    case 7:  // corner to corner
      return {box({1, 1, 1}), shifted(box({1, 1, 1}), {1 - depth, 1 - depth, 1 - depth})};
    case 8:  // rods side by side
      return {cylinder(2, 0.5, 0.5), shifted(cylinder(2, 0.5, 0.5), {1 - depth, 0, 0.5})};
    default:  // a ring about a shaft
      return {cylinder(1, 0.875, 0.875) - shifted(cylinder(2, 0.5, 0.5), {0, 0, -0.5}),
              shifted(cylinder(4, 0.5 + depth, 0.5 + depth), {0, 0, -1})};
  }
}

Scene scene_of(const std::pair<Solid, Solid>& solids, const Transform& transform) {
  return compile(transformed(part("a", solids.first) + part("b", solids.second), transform));
}

}  // namespace

TEST_CASE("Of 50 overlaps, down to 1e-9 of the parts' size, every one is found, with a place in it and its volume") {
  RandomSolids random(1);
  for (int i = 0; i < 50; ++i) {
    const double depth = std::pow(10.0, -1.5 - 7.5 * (i / 10) / 4.0);  // 0.03 to 1e-9
    const Transform transform = i % 2 == 0 ? Transform() : rotation(random.number(1, 89), random.direction());
    const Scene scene = scene_of(pair_of(i % 10, depth), transform);
    const CheckReport report = check(scene);
    INFO("kind " << i % 10 << ", depth " << depth);
    REQUIRE(report.overlaps.size() == 1);
    CHECK(report.undecided.empty());
    CHECK(report.overlaps[0].first == PartId(0));
    CHECK(report.overlaps[0].second == PartId(1));
    Caster caster(scene);
    // What is thinner than a coordinate's rounding may not hold the rounded place.
    for (const std::uint32_t p : {0u, 1u}) {
      const Location location = caster.locate(scene.parts()[p].node, report.overlaps[0].witness);
      CHECK(location != Location::outside);
    }
    CHECK(report.overlaps[0].volume.value + report.overlaps[0].volume.error > 0);
    CHECK(report.overlaps[0].volume.value - report.overlaps[0].volume.error < 20 * depth);
  }
}

TEST_CASE("Of 50 flush contacts none is an overlap") {
  RandomSolids random(2);
  for (int i = 0; i < 50; ++i) {
    const Transform transform = i % 2 == 0 ? Transform() : rotation(random.number(1, 89), random.direction());
    const CheckReport report = check(scene_of(pair_of(i % 10, 0), transform));
    INFO("kind " << i % 10 << ", " << (i % 2 == 0 ? "straight" : "turned"));
    CHECK(report.overlaps.empty());
    for (const Contact& contact : report.undecided) CHECK(contact.most < 1e-9);
  }
}

TEST_CASE("The volume of an overlap is that of what both share") {
  const CheckReport report =
      check(compile(part("a", box({1, 1, 1})) + part("b", shifted(box({1, 1, 1}), {0.75, 0.5, 0}))));
  REQUIRE(report.overlaps.size() == 1);
  CHECK(std::fabs(report.overlaps[0].volume.value - 0.125) <= report.overlaps[0].volume.error + 1e-15);
  CHECK(report.overlaps[0].volume.error < 1e-3);
}

TEST_CASE("All pairs of many parts that overlap are found, in order") {
  std::vector<Solid> parts;
  for (int i = 0; i < 12; ++i)
    parts.push_back(part("ball", shifted(sphere(0.6), {static_cast<double>((i * 5) % 12), 0, 0})));
  const CheckReport report = check(compile(unite(parts)));
  CHECK(report.overlaps.size() == 11);
  for (std::size_t i = 1; i < report.overlaps.size(); ++i)
    CHECK(std::pair(report.overlaps[i - 1].first, report.overlaps[i - 1].second) <
          std::pair(report.overlaps[i].first, report.overlaps[i].second));
}

TEST_CASE("Leaves without effect: hidden, missed, covered together, nothing at all") {
  const Solid block = box({4, 4, 4}, Centering::centered);
  const Solid scene_solid = unite({block - shifted(sphere(1), {9, 0, 0}),           // leaf 1 cuts nothing
                                   sphere(1),                                       // 2: within the block
                                   shifted(box({1, 1, 1}), {2, 0, 0}),              // 3: on its side, seen
                                   block & shifted(box({9, 9, 9}), {-4, -4, -4})})  // 5: holds all of the block (4)
      ;
  const Scene scene = compile(scene_solid);
  const CheckReport report = check(scene);
  std::vector<std::uint32_t> found;
  for (const LeafId leaf : report.without_effect) found.push_back(leaf.index());
  CHECK(std::find(found.begin(), found.end(), 2u) != found.end());
  CHECK(std::find(found.begin(), found.end(), 3u) == found.end());
}

TEST_CASE("A leaf that makes the least of a difference is not without effect") {
  const CheckReport thin = check(compile(box({1, 1, 1}) + box({1, 1, 1 + 1e-9})));
  CHECK(thin.without_effect.size() == 1);  // the lower one
  const CheckReport same = check(compile(box({1, 1, 1}) + box({1, 1, 1})));
  CHECK(same.without_effect.size() <= 2);
}

TEST_CASE("Unbounded and empty parts are told") {
  const Scene scene =
      compile(unite({part("ground", halfspace({0, 0, 1}, 0)), part("ball", shifted(sphere(1), {0, 0, 3})),
                     part("nothing", sphere(1) & shifted(sphere(1), {1, 0, 0}) & halfspace({1, 0, 0}, -5)),
                     part("sunk", shifted(sphere(1), {5, 0, 0.5}))}));
  const CheckReport report = check(scene);
  CHECK(report.is_unbounded);
  CHECK_FALSE(report.is_empty);
  CHECK(report.unbounded == std::vector<PartId>{PartId(0)});
  CHECK(report.empty == std::vector<PartId>{PartId(2)});
  REQUIRE(report.overlaps.size() == 1);
  CHECK(report.overlaps[0].first == PartId(0));
  CHECK(report.overlaps[0].second == PartId(3));
  // A ball cut at half its radius above the middle: pi h² (3 r - h) / 3 with h = 1/2.
  const double cap = M_PI * 0.25 * 2.5 / 3;
  CHECK(std::fabs(report.overlaps[0].volume.value - cap) <= report.overlaps[0].volume.error + 1e-15);
}

TEST_CASE("The empty scene is fine, and says that it is empty") {
  const CheckReport report = check(compile(Solid()));
  CHECK(report.is_empty);
  CHECK(report.overlaps.empty());
  CHECK(report.without_effect.empty());
}

TEST_CASE("A line in the surfaces of both parts proves no overlap") {
  // Disjoint, and the x axis lies in all four surfaces.
  const Solid ball_like = quadric({0, 1, 1, 0, 0, 0}, {0, -2, 0}, 0);
  const Solid a = (halfspace({0, -1, 0}, 0) & halfspace({0, 0, -1}, 0)) - ball_like;
  const Solid b = halfspace({0, -1, 1}, 0) & halfspace({0, 1, 0}, 0.5) & halfspace({0, 0, 1}, 0.5);
  CHECK(check(compile(part("a", a) + part("b", b))).overlaps.empty());
}
