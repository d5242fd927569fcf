// SPDX-License-Identifier: MIT
#include <cmath>

#include "csg/base/length.h"
#include "csg/solid/primitives.h"
#include "raycast/ray/caster.h"
#include "tests/support/at.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

using namespace csgcast;
using test::at;

namespace {

Solid painted(Solid solid, double red) { return with_look(std::move(solid), {{}, Paint{{red, 0, 0}, 1}}); }

Solid glass(Solid solid, double ior) {
  Material material;
  material.transmission = 0.9;
  material.ior = ior;
  return with_look(std::move(solid), {material, {}});
}

struct Scenery {
  explicit Scenery(const Solid& solid) : scene(compile(solid)), caster(scene) {}
  Attribution first(Point origin, Vector direction) {
    caster.begin(Ray(origin, direction));
    return caster.attribute(caster.first_hit().value());
  }
  double red(Point origin, Vector direction) { return scene.look(first(origin, direction).look).color.r; }
  Scene scene;
  Caster caster;
};

}  // namespace

TEST_CASE("a face on a plane that two leaves share belongs to the leaf that is there") {
  Scenery two(box({1, 1, 1}) + at(box({1, 1, 1}), {5, 0, 0}));
  CHECK(two.first({0.5, 0.5, 3}, {0, 0, -1}).leaf == LeafId(0));
  CHECK(two.first({5.5, 0.5, 3}, {0, 0, -1}).leaf == LeafId(1));
}

TEST_CASE("where leaves coincide the first in file order owns the face") {
  Scenery same(painted(box({1, 1, 1}), 0.25) + painted(box({2, 2, 1}), 0.5));
  CHECK(same.red({0.5, 0.5, 3}, {0, 0, -1}) == 0.25);
  CHECK(same.red({1.5, 0.5, 3}, {0, 0, -1}) == 0.5);
}

TEST_CASE("an inlay that is flush with what it is set into shows itself") {
  const Solid block = painted(box({2, 2, 1}), 0.25);
  const Solid inlay = at(box({1, 1, 0.5}), {0.5, 0.5, 0.5});
  Scenery scenery((block - inlay) + painted(inlay, 0.5));
  CHECK(scenery.red({1, 1, 3}, {0, 0, -1}) == 0.5);
  CHECK(scenery.red({0.25, 1, 3}, {0, 0, -1}) == 0.25);
}

TEST_CASE("a cut face shows the look set below the subtraction, else that of what was cut") {
  const Solid block = painted(box({2, 2, 2}), 0.25);
  const Solid bore = at(cylinder(4, 0.5, 0.5), {1, 1, 1});
  Scenery plain(block - bore);
  CHECK(plain.red({1, 1, 5}, {0, 0, -1}) == 0.25);
  Scenery own(block - painted(bore, 0.5));
  CHECK(own.red({1, 1, 5}, {0, 0, -1}) == 0.5);
  Scenery outside(block & complement(bore));
  CHECK(outside.red({1, 1, 5}, {0, 0, -1}) == 0.25);
  // The outermost paint wins, and the cut shows it as well.
  Scenery outer(painted(block - painted(bore, 0.5), 0.75));
  CHECK(outer.red({1, 1, 5}, {0, 0, -1}) == 0.75);
  Scenery nothing_cut(painted(complement(sphere(1)), 0.5));
  CHECK(nothing_cut.red({0, 0, 0}, {0, 0, -1}) == 0.5);
}

TEST_CASE("a face that two subtractions uncover shows its own look") {
  // box - (slot - pin): the pin stands in the slot.
  const Solid pin = at(cylinder(2, 0.25, 0.25), {1, 1, 0});
  Scenery solid(painted(box({2, 2, 2}), 0.25) - (at(box({1, 1, 2}), {0.5, 0.5, 1}) - painted(pin, 0.5)));
  CHECK(solid.red({1, 1, 5}, {0, 0, -1}) == 0.25);  // its top is the block's top: the block is first in file order
  CHECK(solid.red({-3, 1, 1.5}, {1, 0, 0}) == 0.25);
  CHECK(solid.red({0.6, 1, 1.5}, {1, 0, 0}) == 0.5);  // from within the slot onto the pin
}

TEST_CASE("parts have lists of their own, the scene's is their union") {
  const Solid a = named(box({1, 1, 1}), {"a", 1});
  const Solid b = named(at(box({1, 1, 1}), {1, 0, 0}), {"b", 2});
  Scenery scenery(a + b);
  REQUIRE(scenery.scene.parts().size() == 2);
  scenery.caster.begin(Ray({-1, 0.5, 0.5}, {1, 0, 0}));
  IntervalList list;
  scenery.caster.intervals(list);
  REQUIRE(list.size() == 1);
  CHECK(list[0].exit.t == 3);
  scenery.caster.intervals(scenery.scene.parts()[1].node, list);
  REQUIRE(list.size() == 1);
  CHECK(list[0].entry.t == 2);
  CHECK(scenery.caster.attribute(scenery.scene.parts()[1].node, {list[0].entry, Passage::entry}).part == PartId(1));
  CHECK(scenery.caster.part_at({0.5, 0.5, 0.5}) == PartId(0));
  CHECK_FALSE(scenery.caster.part_at({9, 0.5, 0.5}).valid());
}

TEST_CASE("a part below an operator, or within a part, is refused") {
  const Solid part = named(sphere(1), {"p", 1});
  CHECK_THROWS_AS(compile(part - box({1, 1, 1})), Error);
  CHECK_THROWS_AS(compile(named(part, {"q", 1})), Error);
  CHECK_NOTHROW(compile(at(part, {1, 0, 0}) + box({1, 1, 1})));
}

TEST_CASE("locate tells inside, outside and boundary, and touching solids have no boundary between them") {
  Scenery two(box({1, 1, 1}) + at(box({1, 1, 1}), {1, 0, 0}));
  CHECK(two.caster.locate({0.5, 0.5, 0.5}) == Location::inside);
  CHECK(two.caster.locate({1, 0.5, 0.5}) == Location::inside);
  CHECK(two.caster.locate({1, 1, 0.5}) == Location::boundary);
  CHECK(two.caster.locate({0, 0.5, 0.5}) == Location::boundary);
  CHECK(two.caster.locate({std::nextafter(0.0, -1), 0.5, 0.5}) == Location::outside);
  CHECK(two.caster.locate({std::nextafter(2.0, 3), 0.5, 0.5}) == Location::outside);
  Scenery ball(sphere(5));
  CHECK(ball.caster.locate({3, 4, 0}) == Location::boundary);
  CHECK(ball.caster.locate({3, 4, 1e-170}) == Location::outside);
  CHECK_THROWS_AS(ball.caster.locate({NAN, 0, 0}), Error);
}

TEST_CASE("the apex of a pyramid with a thousand sides is on the boundary, at once") {
  std::vector<Point> points{{0, 0, 1}};
  for (int i = 0; i < 1000; ++i) points.push_back({std::cos(0.00628 * i), std::sin(0.00628 * i), 0});
  Scenery pyramid(convex_from_points(points));
  CHECK(pyramid.caster.locate({0, 0, 1}) == Location::boundary);
}

TEST_CASE("a ray that departs from a surface does not meet it again at the start") {
  Scenery ball(sphere(1));
  ball.caster.begin(Ray({-3, 0.3, 0.2}, {1, 0, 0}));
  const Hit hit = ball.caster.first_hit().value();
  const Point p = Ray({-3, 0.3, 0.2}, {1, 0, 0}).at(hit.crossing.t);
  const Attribution there = ball.caster.attribute(hit);
  for (const Vector d : {Vector{-1, 0, 0}, Vector{-1, 0.5, 0.3}, Vector{-1e-3, 1, 0}}) {
    ball.caster.begin(Ray(p, d), Departure{hit.crossing.surface, there.front});
    CHECK_FALSE(ball.caster.first_hit().has_value());
    CHECK_FALSE(ball.caster.any_hit());
  }
  ball.caster.begin(Ray(p, {1, 0, 0}), Departure{hit.crossing.surface, opposite(there.front)});
  const Hit exit = ball.caster.first_hit().value();
  CHECK(exit.passage == Passage::exit);
  CHECK(p.x + exit.crossing.t == Approx(-p.x));
}

TEST_CASE("at a silhouette the side of departure decides, whatever the rounding of the normal") {
  Scenery ball(sphere(1));
  const SurfaceId surface(0);
  // The direction dips into the ball by less than the rounding of the point on it.
  const Point p{std::sqrt(0.5), std::sqrt(0.5), 0};
  const Vector d{-std::sqrt(0.5) - 1e-16, std::sqrt(0.5), 0};
  ball.caster.begin(Ray(p, d), Departure{surface, Sense::positive});
  CHECK_FALSE(ball.caster.any_hit());
}

TEST_CASE("water that touches glass stays two media") {
  Scenery tank(named(glass(box({1, 1, 1}), 1.33), {"water", 1}) +
               named(glass(at(box({1, 1, 1}), {1, 0, 0}), 1.5), {"glass", 1}));
  tank.caster.begin(Ray({-1, 0.5, 0.5}, {1, 0, 0}));
  std::vector<Interface> changes;
  tank.caster.interfaces(changes);
  REQUIRE(changes.size() == 3);
  CHECK_FALSE(changes[0].before.valid());
  CHECK(changes[0].after == RegionId(0));
  CHECK(changes[1].before == RegionId(0));
  CHECK(changes[1].after == RegionId(1));
  CHECK(changes[1].hit.crossing.t == 2);
  CHECK(tank.caster.attribute(changes[1].node, changes[1].hit).part == PartId(1));
  CHECK(changes[2].hit.passage == Passage::exit);
  CHECK_FALSE(changes[2].after.valid());
}

TEST_CASE("where media overlap the first in file order wins, and an opaque solid ends the list") {
  const Solid ball = glass(box({2, 2, 2}), 1.5);
  const Solid core = at(box({2, 2, 2}), {1, 0, 0});
  Scenery glass_first(ball + core);
  std::vector<Interface> changes;
  glass_first.caster.begin(Ray({-1, 1, 1}, {1, 0, 0}));
  glass_first.caster.interfaces(changes);
  REQUIRE(changes.size() == 2);
  CHECK(changes[1].hit.crossing.t == 3);  // the core shows where the glass ends
  CHECK(changes[1].into_opaque);
  Scenery core_first(core + ball);
  core_first.caster.begin(Ray({-1, 1, 1}, {1, 0, 0}));
  core_first.caster.interfaces(changes);
  REQUIRE(changes.size() == 2);
  CHECK(changes[1].hit.crossing.t == 2);
  CHECK(changes[1].into_opaque);
}

TEST_CASE("neighbours of one look are one medium") {
  Scenery slabs(glass(box({1, 1, 1}), 1.5) + painted(at(box({1, 1, 1}), {0, 5, 0}), 1) +
                glass(at(box({1, 1, 1}), {1, 0, 0}), 1.5));
  std::vector<Interface> changes;
  slabs.caster.begin(Ray({-1, 0.5, 0.5}, {1, 0, 0}));
  slabs.caster.interfaces(changes);
  REQUIRE(changes.size() == 2);
  CHECK(changes[1].hit.crossing.t == 3);
}

TEST_CASE("a difference whose left side is missed never looks right") {
  std::vector<Solid> cut{box({1, 1, 1})};
  for (int i = 0; i < 1000; ++i) cut.push_back(at(sphere(0.25), {0.01 * i, 0, 0}));
  Scenery solid(subtract(cut));
  solid.caster.begin(Ray({-5, 0.1, 5}, {1, 0, 0}));
  CHECK_FALSE(solid.caster.first_hit().has_value());
  CHECK(solid.caster.counts().leaf_tests == 0);
  CHECK(solid.caster.counts().box_tests == 1);
}

TEST_CASE("boxes cull: a ray through a thousand balls in a row looks at few of another thousand") {
  std::vector<Solid> balls;
  for (int i = 0; i < 1000; ++i) {
    for (int j = 0; j < 10; ++j) balls.push_back(at(sphere(0.4), {1.0 * i, 1.0 * j, 0}));
  }
  Scenery solid(unite(balls));
  solid.caster.begin(Ray({500, 4, 5}, {0, 0, -1}));
  CHECK(solid.caster.first_hit().has_value());
  CHECK(solid.caster.counts().leaf_tests <= 4);
}

TEST_CASE("a million operators inside each other are compiled, asked and destroyed") {
  Solid solid = sphere(1);
  const Solid ball = sphere(0.5);
  for (int i = 0; i < test::times(500000); ++i) solid = (solid & at(box({4, 4, 4}), {-2, -2, -2})) + ball;
  Scenery deep(solid);
  deep.caster.begin(Ray({-3, 0, 0}, {1, 0, 0}));
  CHECK(deep.caster.first_hit().value().crossing.t == Approx(2));
  CHECK(deep.caster.locate({0, 0, 0}) == Location::inside);
}

TEST_CASE("transforms that cannot be composed exactly in reason are refused") {
  Solid solid = sphere(1);
  for (int i = 0; i < 2000; ++i) solid = transformed(solid, rotation(Vector{1, 2, 3}));
  CHECK_THROWS_AS(compile(solid), Error);
  Solid moved = sphere(1);
  for (int i = 0; i < 2000; ++i) moved = at(moved, {0.1, 0, 0});
  CHECK_NOTHROW(compile(moved));
}

TEST_CASE("solids beyond the range of the engine are refused, those at its ends are not") {
  const auto scaled = [](double s) { return transformed(box({1, 1, 1}), scaling({s, s, s})); };
  CHECK_THROWS_AS(compile(scaled(0x1p401)), Error);
  CHECK_THROWS_AS(compile(transformed(scaled(1e200), scaling({1e200, 1e200, 1e200}))), Error);
  CHECK_THROWS_AS(compile(scaled(0x1p-401)), Error);
  for (const double s : {0x1p399, 0x1p-399}) {
    Scenery scenery(scaled(s));
    scenery.caster.begin(Ray({-s, s / 2, s / 2}, {s, 0, 0}));
    CHECK(scenery.caster.first_hit().value().crossing.t == 1);
  }
}

TEST_CASE("a crossing beyond the doubles has a face, and its t is infinite") {
  const Scene scene = compile(halfspace({0, 0, 1}, 0) + box({1, 1, 1}));
  Caster caster(scene);
  caster.begin(Ray({4, 0, 2}, {1, 0, -0x1p-1073}));
  const std::optional<Hit> hit = caster.first_hit();
  REQUIRE(hit);
  CHECK(std::isinf(hit->crossing.t));
  CHECK(caster.attribute(*hit).leaf == LeafId(0));
  CHECK(caster.attribute(*hit).normal == Normal{0, 0, 1});
}

TEST_CASE("a ray that leads out of the face it departs from is outside, whatever side is claimed") {
  const Scene scene = compile(box({1, 1, 1}));
  for (const Predicates* predicates : {&certified_predicates(), &exact_predicates(), &uncertified_predicates()}) {
    Caster caster(scene, *predicates);
    const auto list_of = [&](Vector d, Sense side) {
      caster.begin(Ray({1, 0.5, 0.5}, d), Departure{SurfaceId(1), side});
      IntervalList list;
      caster.intervals(list);
      return list;
    };
    for (const Sense side : {Sense::negative, Sense::positive}) {
      CHECK(list_of({1, 0.1, 0.1}, side).empty());
      CHECK(list_of({0x1p-200, 1, 1}, side).empty());
      CHECK(list_of({-0x1p-200, 1, 1}, side).size() == 1);
    }
    // Within the face only the claim tells.
    CHECK(list_of({0, 1, 1}, Sense::positive).empty());
    CHECK(list_of({0, 1, 1}, Sense::negative).size() == 1);
  }
}

TEST_CASE("a departure nearly along a generator has a face where its list ends beyond the leaf's box") {
  const Solid cone = quadric({1, 1, -1, 0, 0, 0}, {}, 0) & box({6, 6, 6}, Centering::centered);
  const Scene scene = compile(cone - box({0.5, 0.5, 9}));
  Caster caster(scene);
  const Ray ray({0x1.2e5e930da6d13p-4, 0x1.a0afa142c87c3p-2, -0x1.cac4a9e4b9c47p-1},
                {0x1.0459988403068p-7, -0x1.54336b7095792p+0, 0x1.ef470bdc959f5p-2});
  for (const Sense side : {Sense::negative, Sense::positive}) {
    caster.begin(ray, Departure{SurfaceId(0), side});
    IntervalList list;
    caster.intervals(list);
    for (const Interval& interval : list) {
      if (interval.entry.surface.valid()) CHECK(caster.attribute({interval.entry, Passage::entry}).leaf.valid());
      if (interval.exit.surface.valid()) CHECK(caster.attribute({interval.exit, Passage::exit}).leaf.valid());
    }
  }
}

TEST_CASE("a hit point lies on its surface however far away the ray starts") {
  const Scene scene = compile(at(sphere(1), {3, 4, 5}));
  Caster caster(scene);
  for (const double distance : {1.0, 1e6, 1e12}) {
    const Vector d = normalised({0.3, -0.5, 0.81});
    caster.begin(Ray(Point{3, 4, 5} - distance * d, d));
    const std::optional<Hit> hit = caster.first_hit(Span::line());
    REQUIRE(hit);
    const Point p = caster.attribute(*hit).point;
    CHECK(std::fabs(length(p - Point{3, 4, 5}) - 1) < 1e-15 * 8);
  }
}

TEST_CASE("a shared solid of 2^40 leaves is an error, and no leaf of it is made") {
  Solid doubled = sphere(1);
  for (int i = 0; i < 40; ++i) doubled = unite({doubled, at(doubled, {std::ldexp(3, i), 0, 0})});
  try {
    compile(doubled);
    FAIL("it was compiled");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::limit);
  }
}
