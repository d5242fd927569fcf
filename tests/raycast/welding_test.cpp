// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "csg/solid/leaf_shape.h"
#include "csg/solid/primitives.h"
#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"
#include "raycast/ray/caster.h"
#include "tests/support/at.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/random_solid.h"
#include "tests/support/rounded_leaves.h"

using namespace csgcast;
using test::at;
using test::RandomSolids;

namespace {

Solid flush() { return text::build(text::read_file(CSGCAST_SOURCE_DIR "/examples/flush.csg")).solid; }

std::size_t length_of(const Scene& scene, const Ray& ray) {
  Caster caster(scene);
  caster.begin(ray);
  IntervalList list;
  caster.intervals(list, Span::line());
  return list.size();
}

// A placement in space: any rotation, any scale from 1/100 to 100, and a place about `distance` away.
Transform random_placement(RandomSolids& random, double distance) {
  Transform m = rotation(random.number(0, 360), random.direction());
  const double scale = std::pow(10.0, random.number(-2, 2));
  for (double& entry : m.entry) entry *= scale;
  const Vector offset = distance * random.direction();
  for (std::size_t row = 0; row < 3; ++row) m.entry[4 * row + 3] = offset[row];
  return m;
}

// Rays through the images of the box of the unmoved solid; every third nearly along one of its faces.
Ray random_ray(RandomSolids& random, const Box& box, const Transform& placement) {
  const auto point = [&] {
    const Vector size = box.size();
    return box.lower + Vector{size.x * random.number(-0.1, 1.1), size.y * random.number(-0.1, 1.1),
                              size.z * random.number(-0.1, 1.1)};
  };
  Point a = point();
  Point b = point();
  if (random.index(3) == 0) b[random.index(3)] = a[random.index(3)] + std::pow(10.0, -random.number(2, 5));
  const Point from = test::image(placement, a + 5 * (a - b));
  const Vector d = test::image(placement, b) - from;
  return d == Vector{} ? Ray(from, {1, 0, 0}) : Ray(from, d);
}

// As many intervals, at about the same places.
bool same_structure(const IntervalList& a, const IntervalList& b) {
  const auto close = [](double s, double t) { return s == t || std::fabs(s - t) < 1e-3; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const Interval& i, const Interval& j) {
    return close(i.entry.t, j.entry.t) && close(i.exit.t, j.exit.t);
  });
}

}  // namespace

TEST_CASE("flush with one rounded transform a leaf, anywhere and any way up, welds to the lists of the exact one") {
  const Solid solid = flush();
  const Box box{{0, 0, 0}, {6, 6, 1}};
  RandomSolids random(7);
  const int placements = test::long_run() ? 1000 : test::times(40);
  for (const double distance : {0.0, 1e4, 1e6}) {
    int wrong = 0, wrong_unwelded = 0, incomplete = 0;
    for (int trial = 0; trial < placements; ++trial) {
      const Transform placement = random_placement(random, distance);
      const Scene exact = compile(transformed(solid, placement));
      const Solid rounded = test::with_rounded_leaves(solid, placement);
      const Scene welded = compile(rounded, Welding::derived());
      const Scene unwelded = compile(rounded);
      incomplete += welded.surfaces().size() != exact.surfaces().size();
      Caster of_exact(exact), of_welded(welded), of_unwelded(unwelded);
      IntervalList expected, list;
      for (int i = 0; i < 200; ++i) {
        const Ray ray = random_ray(random, box, placement);
        of_exact.begin(ray);
        of_exact.intervals(expected, Span::line());
        of_welded.begin(ray);
        of_welded.intervals(list, Span::line());
        wrong += !same_structure(expected, list);
        of_unwelded.begin(ray);
        of_unwelded.intervals(list, Span::line());
        wrong_unwelded += !same_structure(expected, list);
      }
    }
    if (test::long_run()) {
      WARN(fmt::format("{} placements of 200 rays at {}: {} lists wrong, {} without welding", placements, distance,
                       wrong, wrong_unwelded));
    }
    CHECK(wrong == 0);
    CHECK(incomplete == 0);
    CHECK(wrong_unwelded > 0);
  }
}

TEST_CASE("shells and plates that are more than rounding survive welding") {
  const auto survives = [](double distance, double gap) {
    const Vector offset{0.6 * distance, 0.48 * distance, 0.64 * distance};
    for (const Solid& leaf : {sphere(1), box({2, 2, 2}, Centering::centered), cylinder(2, 1, 1, Centering::centered)}) {
      const double grown = 1 + gap;
      const Solid outer = transformed(leaf, {{grown, 0, 0, offset.x, 0, grown, 0, offset.y, 0, 0, grown, offset.z}});
      const Scene scene = compile(outer - at(leaf, offset), Welding::derived());
      if (length_of(scene, Ray(Point{} + offset - Vector{4, 0.01, 0.02}, {1, 0, 0})) != 2) return false;
    }
    return true;
  };
  CHECK(survives(0, 1e-13));
  CHECK(survives(1e4, 1e-9));
  CHECK(survives(1e6, 1e-8));
  // Less than the rounding of the transforms is none.
  CHECK_FALSE(survives(1e4, 1e-13));
  CHECK_FALSE(survives(1e6, 1e-11));
}

TEST_CASE("a transform that all have in common adds nothing to what welds") {
  const Solid shell = sphere(1) - sphere(1 - 1e-13);
  const Scene scene = compile(at(shell, {1e6, -2e6, 5e5}), Welding::derived());
  CHECK(scene.weld_report().surfaces == 0);
  CHECK(length_of(scene, Ray({1e6 - 4, -2e6, 5e5}, {1, 0, 0})) == 2);
}

TEST_CASE("the sum of 0.1 and 0.2 welds to 0.3, and a double more does not") {
  const auto gap = [](double top) {
    const Solid solid = box({1, 1, 0.1 + 0.2}) + at(box({1, 1, 1}), {0, 0, top});
    return compile(solid, Welding::derived()).weld_report().surfaces;
  };
  CHECK(gap(0.3) == 1);
  CHECK(gap(0.3 - 1e-15) == 0);
  CHECK(gap(0.3 + 1e-15) == 0);
}

TEST_CASE("what welds does not depend on the order of the file") {
  RandomSolids random(11);
  const Transform placement = random_placement(random, 1e4);
  std::vector<Solid> bricks;
  for (int i = 0; i < 12; ++i)
    bricks.push_back(test::with_rounded_leaves(at(box({1, 1, 1}), {double(i % 4), double(i / 4), 0}), placement));
  const auto forms = [](const std::vector<Solid>& list) {
    const Scene scene = compile(unite(list), Welding::derived());
    std::vector<std::array<double, 10>> result;
    for (const Surface& surface : scene.surfaces()) result.push_back(surface.world);
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto expected = forms(bricks);
  CHECK(expected.size() == 5 + 4 + 2);
  for (int i = 0; i < 20; ++i) {
    for (std::size_t k = bricks.size(); k > 1; --k) std::swap(bricks[k - 1], bricks[random.index(k)]);
    CHECK(forms(bricks) == expected);
  }
}

TEST_CASE("a cluster of surfaces never grows wider than its members' own rounding") {
  // A row of spheres, each an ulp or two larger than the one before: neighbours could be one, the first and last not.
  std::vector<Solid> spheres;
  double radius = 1;
  for (int i = 0; i < 64; ++i, radius = std::nextafter(radius, 2)) spheres.push_back(sphere(radius));
  const Scene scene = compile(unite(spheres), Welding::derived());
  CHECK(scene.weld_report().surfaces > 0);
  CHECK(scene.surfaces().size() >= 64 / 3);
  CHECK(scene.weld_report().widest < 0x1p-51);
}

TEST_CASE("a plate thinner than its own rounding vanishes when welded, and only then") {
  const Solid plate = box({1, 1, 1}) & complement(box({2, 2, std::nextafter(1.0, 0)}));
  CHECK(length_of(compile(plate), Ray({0.5, 0.5, -1}, {0, 0, 1})) == 1);
  CHECK(length_of(compile(plate, Welding::derived()), Ray({0.5, 0.5, -1}, {0, 0, 1})) == 0);
  const Solid thin = box({2, 2, 1e-300});
  CHECK(length_of(compile(thin, Welding::derived()), Ray({0.5, 0.5, -1}, {0, 0, 1})) == 1);
}

TEST_CASE("a tolerance by hand welds what is nearer, and near misses name one that does") {
  const Solid solid =
      box({1, 1, 1}) + at(box({1, 1, 1}), {1 + 1e-6, 0, 0}) + at(cylinder(1, 0.2, 0.2), {0.5, 0.5, 1 + 3e-6});
  Welding derived = Welding::derived();
  derived.lists_near_misses = true;
  const WeldReport report = compile(solid, derived).weld_report();
  CHECK(report.surfaces == 0);
  CHECK(report.near_miss_count == 2);
  REQUIRE(report.near_misses.size() >= 1);
  CHECK(report.near_misses.front().gap == Approx(1e-6));
  const double size = report.size;
  CHECK(compile(solid, Welding::by_hand(0.5e-6 / size)).weld_report().surfaces == 0);
  CHECK(compile(solid, Welding::by_hand(2e-6 / size)).weld_report().surfaces == 1);
  const Scene welded = compile(solid, Welding::by_hand(report.suggested_tolerance));
  CHECK(welded.weld_report().surfaces == 2);
  CHECK(length_of(welded, Ray({-1, 0.5, 0.5}, {1, 0, 0})) == 1);
  CHECK(length_of(welded, Ray({0.5, 0.5, 3}, {0, 0, -1})) == 1);
  CHECK_THROWS_AS(compile(solid, Welding::by_hand(0.5)), Error);
  CHECK_THROWS_AS(compile(solid, Welding::by_hand(std::nan(""))), Error);
}

TEST_CASE("curved faces and faces of convex solids weld too") {
  RandomSolids random(13);
  const std::vector<Point> wedge{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, {2, 0, 1}, {0, 2, 1}};
  std::vector<Point> half_wedge = wedge;
  for (Point& p : half_wedge) p = {0.5 * p.x, 0.5 * p.y, 0.5 * p.z};
  const std::vector<PlaneEquation> slab{{{0, 0, 1}, 1},  {{0, 0, -1}, 0}, {{1, 0, 0}, 2},
                                        {{-1, 0, 0}, 0}, {{0, 1, 0}, 2},  {{0, -1, 0}, 0}};
  const std::vector<std::pair<Solid, Solid>> twins{
      {cylinder(1, 2, 1), at(cylinder(1, 2, 1, Centering::centered), {0, 0, 0.5})},
      {sphere(2), transformed(sphere(1), scaling({2, 2, 2}))},
      {ellipsoid({1, 2, 3}), transformed(sphere(1), scaling({1, 2, 3}))},
      {paraboloid(2, 1), transformed(paraboloid(1, 1), scaling({1, 1, 2}))},
      {hyperboloid(2, 2, 1), transformed(hyperboloid(1, 1, 0.5), scaling({2, 2, 2}))},
      {convex_from_points(wedge), transformed(convex_from_points(half_wedge), scaling({2, 2, 2}))},
      {convex_from_planes(slab), box({2, 2, 1})}};
  int apart = 0;
  for (const double distance : {0.0, 1e5}) {
    for (const auto& [a, b] : twins) {
      const Transform placement = random_placement(random, distance);
      const Solid there = test::with_rounded_leaves(a, placement);
      // The same place by another way round.
      const Solid around = transformed(transformed(b, rotation({0, 0, 17})), rotation({0, 0, -17}));
      CAPTURE(a.shape().kind, distance);
      const Solid both = there + test::with_rounded_leaves(around, placement);
      apart += compile(both).surfaces().size() > compile(there).surfaces().size();
      CHECK(compile(both, Welding::derived()).surfaces().size() == compile(there).surfaces().size());
    }
  }
  CHECK(apart >= 8);
}

TEST_CASE("what one leaf or one chain of transforms tells apart stays apart, whatever else is near") {
  // A plate under one transform, and a block that is flush with its lower face by another.
  const Solid plate = at(box({1, 1, 1e-10}), {0, 0, 1e6});
  const Solid block = at(at(box({5.5, 10, 1}), {-5, -5, -1000001}), {0, 0, 2e6});
  const Ray through({0.7, 0.3, 1e6 + 1}, {0, 0, -1});
  CHECK(length_of(compile(plate + block, Welding::derived()), through) == 1);
  CHECK(length_of(compile(block + plate, Welding::derived()), through) == 1);
}

TEST_CASE("a wider tolerance by hand never welds less") {
  const Solid solid = box({1, 1, 1}) + at(box({1, 1, 1}), {0, 0, 1.00001}) + at(box({1, 1, 1}), {0, 0, 20});
  std::size_t before = 0;
  for (const double tolerance : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 2e-3, 3e-3, Welding::greatest_tolerance}) {
    const std::size_t welded = compile(solid, Welding::by_hand(tolerance)).weld_report().surfaces;
    CHECK(welded >= before);
    before = welded;
  }
  CHECK(before == 1);
}

TEST_CASE("leaves that are small beside the scene weld by hand, too") {
  RandomSolids random(17);
  std::vector<Solid> rivets;
  for (int i = 0; i < 300; ++i) {
    Transform m = rotation(random.number(0, 360), random.direction());
    for (double& entry : m.entry) entry = std::round(entry * 1e6) / 1e6;
    const Vector place{random.number(0, 100), random.number(0, 100), random.number(0, 100)};
    const Solid pin = transformed(cylinder(0.02, 0.01, 0.01), m);
    Transform tilted = m;
    tilted.entry[2] += 1e-6;
    rivets.push_back(at(pin, place) + at(transformed(cylinder(0.02, 0.01, 0.01), tilted), place));
  }
  const Scene scene = compile(unite(rivets), Welding::by_hand(1e-6));
  CHECK(scene.surfaces().size() == 3 * 300);
  CHECK_FALSE(scene.weld_report().incomplete);
}

TEST_CASE("a tolerance is relative to the solid also where it is made of half-spaces alone") {
  std::vector<Solid> sides;
  for (const double sign : {1.0, -1.0}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Vector n;
      n[axis] = sign;
      sides.push_back(halfspace(n, 1e-6));
    }
  }
  const Scene scene = compile(intersect(sides), Welding::by_hand(1e-3));
  CHECK(scene.weld_report().surfaces == 0);
  CHECK(length_of(scene, Ray({-1, 0, 0}, {1, 0, 0})) == 1);
  CHECK(compile(halfspace({1, 0, 0}, 1) + halfspace({1, 0, 0}, 1 + 1e-9), Welding::by_hand(1e-3))
            .weld_report()
            .surfaces == 0);
}

TEST_CASE("thousands of surfaces that nearly coincide take neither long nor much") {
  std::vector<Solid> spheres;
  for (int i = 0; i < test::times(20'000); ++i) spheres.push_back(sphere(1 + i * 0x1p-52));
  const Scene scene = compile(unite(spheres), Welding::derived());
  CHECK(scene.surfaces().size() < 20'000);
  Welding by_hand = Welding::by_hand(1e-6);
  by_hand.lists_near_misses = true;
  CHECK(compile(unite(spheres), by_hand).surfaces().size() < 20'000);
}

TEST_CASE("numbers too far apart to be told from each other weld nothing") {
  const Scene scene = compile(box({1, 1, 1}) + at(box({1, 1, 1}), {1e100, 0, 0}), Welding::derived());
  CHECK(scene.weld_report().surfaces == 0);
  CHECK(length_of(scene, Ray({0.5, 0.5, 0.5}, {1, 0, 0})) == 2);
}

TEST_CASE("a thin wall survives a block that is flush with it by another way round") {
  const Solid hollow = box({1, 1, 1}) - at(box({0.9, 0.8, 0.8}), {1e-13, 0.1, 0.1});
  const Solid remote = at(at(box({1, 1, 1}), {-1e6, 0, 0}), {2e6, 5, 0});
  const Scene scene = compile(at(hollow, {1e6, 0, 0}) + remote, Welding::derived());
  CHECK(length_of(scene, Ray({1e6, 0.5, 0.5}, {1, 0, 0})) == 2);
}
