// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <vector>

#include "csg/solid/primitives.h"
#include "raycast/ray/caster.h"
#include "tests/support/catch.h"

using namespace csgcast;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

struct Ends {
  double from;
  double to;
};

IntervalList list_of(const Solid& solid, Point origin, Vector direction, Span span = Span::line()) {
  const Scene scene = compile(solid);
  Caster caster(scene);
  caster.begin(Ray(origin, direction));
  IntervalList list;
  caster.intervals(list, span);
  return list;
}

// Roots of quadrics are a few roundings away from these round numbers.
void check(const IntervalList& list, const std::vector<Ends>& expected) {
  REQUIRE(list.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(list[i].entry.t == Approx(expected[i].from).epsilon(1e-14).margin(1e-14));
    CHECK(list[i].exit.t == Approx(expected[i].to).epsilon(1e-14).margin(1e-14));
  }
}

}  // namespace

TEST_CASE("a ray along a cube's diagonal enters once and leaves once") {
  check(list_of(box({1, 1, 1}), {-1, -1, -1}, {1, 1, 1}), {{1, 2}});
}

TEST_CASE("a ray beside a cube meets nothing, one in its face is outside or inside by the sign of the normal") {
  const Solid cube = box({1, 1, 1});
  check(list_of(cube, {-1, 2, 0.5}, {1, 0, 0}), {});
  // On the positive side of y = 1: outside. On the positive side of y = 0: inside.
  check(list_of(cube, {-1, 1, 0.5}, {1, 0, 0}), {});
  check(list_of(cube, {-1, 0, 0.5}, {1, 0, 0}), {{1, 2}});
  // The edge y = z = 0 is on the positive sides of both its planes.
  check(list_of(cube, {-1, 0, 0}, {1, 0, 0}), {{1, 2}});
  check(list_of(cube, {-1, 0, 1}, {1, 0, 0}), {});
}

TEST_CASE("t counts in units of the direction") {
  check(list_of(box({1, 1, 1}), {-2, 0.5, 0.5}, {4, 0, 0}), {{0.5, 0.75}});
  check(list_of(sphere(1), {0, 0, -3}, {0, 0, 0.5}), {{4, 8}});
}

TEST_CASE("a ball is met twice, a tangent line encloses no interval") {
  check(list_of(sphere(1), {0, 0, -3}, {0, 0, 1}), {{2, 4}});
  check(list_of(sphere(1), {1, 0, -3}, {0, 0, 1}), {});
  check(list_of(sphere(1), {1.5, 0, -3}, {0, 0, 1}), {});
}

TEST_CASE("a ray starts at t = 0 unless asked for the line") {
  check(list_of(sphere(1), {0, 0, 0}, {0, 0, 1}, Span{}), {{0, 1}});
  check(list_of(sphere(1), {0, 0, 0}, {0, 0, 1}), {{-1, 1}});
  check(list_of(sphere(1), {0, 0, 3}, {0, 0, 1}, Span{}), {});
}

TEST_CASE("an interval that starts exactly at t = 0 keeps its surface, one that ends there vanishes") {
  const IntervalList entering = list_of(box({1, 1, 1}), {0, 0.5, 0.5}, {1, 0, 0}, Span{});
  check(entering, {{0, 1}});
  CHECK(entering[0].entry.surface.valid());
  check(list_of(box({1, 1, 1}), {1, 0.5, 0.5}, {1, 0, 0}, Span{}), {});
  const IntervalList inside = list_of(box({1, 1, 1}), {0.5, 0.5, 0.5}, {1, 0, 0}, Span{});
  check(inside, {{0, 0.5}});
  CHECK_FALSE(inside[0].entry.surface.valid());
}

TEST_CASE("a span cuts intervals off without a surface") {
  const IntervalList cut = list_of(box({4, 1, 1}), {-1, 0.5, 0.5}, {1, 0, 0}, Span{2, 3});
  check(cut, {{2, 3}});
  CHECK_FALSE(cut[0].entry.surface.valid());
  CHECK_FALSE(cut[0].exit.surface.valid());
}

TEST_CASE("cylinders and cones: side, caps, apex, parallel lines") {
  const Solid tube = cylinder(2, 1, 1);
  check(list_of(tube, {-3, 0, 1}, {1, 0, 0}), {{2, 4}});
  check(list_of(tube, {0.5, 0, -1}, {0, 0, 1}), {{1, 3}});
  check(list_of(tube, {1, 0, -1}, {0, 0, 1}), {});  // a generator is outside
}

TEST_CASE("a cone's apex is entered and left through its sides") {
  const Solid cone = cylinder(1, 1, 0);
  check(list_of(cone, {-2, 0, 0.5}, {1, 0, 0}), {{1.5, 2.5}});
  check(list_of(cone, {0, 0, 3}, {0, 0, -1}), {{2, 3}});
  check(list_of(cone, {-1, 0, 1}, {1, 0, 0}), {});  // touches the apex only
  const Solid frustum = cylinder(2, 2, 1);
  check(list_of(frustum, {-4, 0, 1}, {1, 0, 0}), {{2.5, 5.5}});
}

TEST_CASE("ellipsoids, paraboloids and hyperboloids") {
  check(list_of(ellipsoid({1, 2, 3}), {0, 0, -6}, {0, 0, 1}), {{3, 9}});
  check(list_of(ellipsoid({1, 2, 3}), {0, -6, 0}, {0, 1, 0}), {{4, 8}});
  check(list_of(paraboloid(2, 1), {0, 0, -1}, {0, 0, 1}), {{1, 3}});
  check(list_of(paraboloid(2, 1), {-3, 0, 0.5}, {1, 0, 0}), {{2.5, 3.5}});
  check(list_of(hyperboloid(2, 2, 1), {-3, 0, 0}, {1, 0, 0}), {{2, 4}});
  check(list_of(hyperboloid(2, 2, 1), {0, 0, -3}, {0, 0, 1}), {{2, 4}});
}

TEST_CASE("quadrics of every kind have up to two runs inside") {
  // Two sheets: z² - x² - y² >= 1.
  check(list_of(quadric({1, 1, -1, 0, 0, 0}, {}, 1), {0, 0, 0}, {0, 0, 1}), {{-inf, -1}, {1, inf}});
  // A double cone.
  check(list_of(quadric({1, 1, -1, 0, 0, 0}, {}, 0), {0, 0.5, 0}, {0, 0, 1}), {{-inf, -0.5}, {0.5, inf}});
  // A hyperbolic paraboloid: z >= x y.
  check(list_of(quadric({0, 0, 0, 0.5, 0, 0}, {0, 0, -1}, 0), {2, 3, 0}, {0, 0, 1}), {{6, inf}});
  // A slab between two planes, and what is outside of it.
  check(list_of(quadric({1, 0, 0, 0, 0, 0}, {}, -4), {0, 0, 0}, {1, 0, 0}), {{-2, 2}});
  check(list_of(quadric({-1, 0, 0, 0, 0, 0}, {}, 4), {0, 0, 0}, {1, 0, 0}), {{-inf, -2}, {2, inf}});
  // A double plane has no inside; its complement is everything.
  check(list_of(quadric({1, 0, 0, 0, 0, 0}, {}, 0), {-1, 0, 0}, {1, 0, 0}), {});
  check(list_of(complement(quadric({1, 0, 0, 0, 0, 0}, {}, 0)), {-1, 0, 0}, {1, 0, 0}), {{-inf, inf}});
}

TEST_CASE("half-spaces, complements and everything are unbounded") {
  check(list_of(halfspace({0, 0, 2}, 2), {0, 0, 5}, {0, 0, -1}), {{4, inf}});
  check(list_of(complement(sphere(1)), {0, 0, -3}, {0, 0, 1}), {{-inf, 2}, {4, inf}});
  check(list_of(Solid::everything(), {0, 0, 0}, {0, 0, 1}, Span{}), {{0, inf}});
  check(list_of(Solid(), {0, 0, 0}, {0, 0, 1}), {});
}

TEST_CASE("faces that touch join, faces that coincide cut clean") {
  const Solid left = box({1, 1, 1});
  const Solid right = transformed(box({1, 1, 1}), translation({1, 0, 0}));
  check(list_of(left + right, {-1, 0.5, 0.5}, {1, 0, 0}), {{1, 3}});
  check(list_of(left & right, {-1, 0.5, 0.5}, {1, 0, 0}), {});
  check(list_of(left - left, {-1, 0.5, 0.5}, {1, 0, 0}), {});
  check(list_of(left - right, {-1, 0.5, 0.5}, {1, 0, 0}), {{1, 2}});
  const Solid lower_half = box({1, 1, 0.5});
  check(list_of(left - lower_half, {0.5, 0.5, -1}, {0, 0, 1}), {{1.5, 2}});
}

TEST_CASE("surfaces that are equal in different coordinates are one surface") {
  const Solid scaled = transformed(box({1, 1, 1}), scaling({2, 2, 2}));
  const Scene scene = compile(scaled + box({2, 2, 2}));
  CHECK(scene.surfaces().size() == 6);
  CHECK(scene.leaves().size() == 2);
  const Scene mirrored =
      compile(transformed(sphere(1), mirroring({1, 0, 0})) + sphere(1) + transformed(sphere(0.5), scaling({2, 2, 2})));
  CHECK(mirrored.surfaces().size() == 1);
}

TEST_CASE("a zero or infinite direction is refused") {
  CHECK_THROWS_AS(Ray({}, {}), Error);
  CHECK_THROWS_AS(Ray({}, {inf, 0, 0}), Error);
  CHECK_THROWS_AS(Ray({std::nan(""), 0, 0}, {1, 0, 0}), Error);
}
