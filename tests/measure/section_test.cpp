// SPDX-License-Identifier: MIT
#include "measure/section.h"

#include <cmath>

#include "csg/base/error.h"
#include "csg/solid/primitives.h"
#include "raycast/ray/caster.h"
#include "tests/support/catch.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using test::RandomSolids;

namespace {

Section cut(const Solid& solid, Vector normal, double distance) { return section(compile(solid), {normal, distance}); }

bool holds(Measured m, double truth) { return std::fabs(m.value - truth) <= m.error + 1e-14 * (1 + std::fabs(truth)); }

double at(const std::array<double, 6>& k, PlanePoint p) {
  return (k[0] * p.u + k[1] * p.v + k[3]) * p.u + (k[2] * p.v + k[4]) * p.v + k[5];
}

// Loops are closed, and their ends and middles lie on their curves.
void check_loops(const Section& s, double size) {
  CHECK(s.is_closed);
  for (const SectionLoop& loop : s.loops) {
    REQUIRE(loop.size() >= 2);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const SectionArc& arc = loop[i];
      const SectionArc& next = loop[(i + 1) % loop.size()];
      CHECK(std::hypot(arc.to.u - next.from.u, arc.to.v - next.from.v) <= 2 * s.place_error);
      for (const PlanePoint p : {arc.from, arc.middle, arc.to}) CHECK(std::fabs(at(arc.conic, p)) < 1e-9 * size * size);
    }
  }
}

}  // namespace

TEST_CASE("Sections with closed forms: discs, squares, ellipses, rings, a parabola's and a hyperbola's segment") {
  const Section disc = cut(sphere(1), {0, 0, 2}, 1);
  CHECK(holds(disc.area, M_PI * 0.75));
  CHECK(holds(disc.perimeter, 2 * M_PI * std::sqrt(0.75)));
  CHECK(disc.loops.size() == 1);
  check_loops(disc, 1);
  const Section square = cut(box({1, 2, 3}), {0, 0, 1}, 1);
  CHECK(holds(square.area, 2));
  CHECK(holds(square.perimeter, 6));
  REQUIRE(square.loops.size() == 1);
  CHECK(square.loops[0].size() == 4);
  CHECK(square.loops[0][0].is_straight());
  check_loops(square, 3);
  const Section ellipse = cut(cylinder(4, 1, 1, Centering::centered), {0, 1, 1}, 0);
  CHECK(holds(ellipse.area, M_PI * std::sqrt(2)));
  check_loops(ellipse, 2);
  const Section ring = cut(sphere(1) - sphere(0.5), {1, 0, 0}, 0);
  CHECK(holds(ring.area, M_PI * 0.75));
  CHECK(holds(ring.perimeter, 3 * M_PI));
  CHECK(ring.loops.size() == 2);
  const Section parabola = cut(paraboloid(2, 1), {1, 0, 0}, 0);
  CHECK(holds(parabola.area, 2.0 / 3 * 2 * 2));
  check_loops(parabola, 2);
  // z² = x² + y² at y = 1/2, up to z = 1.
  const Section hyperbola = cut(cylinder(1, 0, 1), {0, 1, 0}, 0.5);
  const double a = 0.5, x = std::sqrt(0.75);
  CHECK(holds(hyperbola.area, 2 * x - (x + a * a * std::asinh(x / a))));
  check_loops(hyperbola, 1);
}

TEST_CASE("The plane's directions are unit, square and right-handed, and its origin is nearest to the scene's") {
  const Section s = cut(sphere(2), {1, -2, 2}, 3);
  CHECK(s.u.z == Approx(0).margin(1e-15));
  CHECK(s.v.z > 0);
  CHECK(dot(s.u, s.u) == Approx(1));
  CHECK(dot(s.u, s.v) == Approx(0).margin(1e-15));
  const Vector n = cross(s.u, s.v);
  CHECK(n.x == Approx(1.0 / 3));
  CHECK(n.y == Approx(-2.0 / 3));
  CHECK(s.origin.x == Approx(1.0 / 3));
  CHECK(holds(s.area, 3 * M_PI));
}

TEST_CASE("In the plane of a face the section is the one just beyond") {
  const Solid step = box({2, 2, 1}) + transformed(box({1, 1, 1}), translation({0, 0, 1}));
  CHECK(holds(cut(step, {0, 0, 1}, 1).area, 1));
  CHECK(holds(cut(step, {0, 0, -1}, -1).area, 4));
  CHECK(holds(cut(step, {0, 0, 1}, 0).area, 4));
  CHECK(holds(cut(step, {0, 0, 1}, 2).area, 0));
  const Solid turned = transformed(step, rotation(30, Vector{0, 0, 1}));
  CHECK(holds(cut(turned, {0, 0, 1}, 1).area, 1));
}

TEST_CASE("Empty and unbounded sections are told apart from others") {
  CHECK(holds(cut(sphere(1), {0, 0, 1}, 5).area, 0));
  CHECK(cut(sphere(1), {0, 0, 1}, 5).loops.empty());
  CHECK(cut(Solid(), {0, 0, 1}, 0).loops.empty());
  CHECK_FALSE(cut(halfspace({1, 0, 0}, 0), {0, 0, 1}, 0).is_bounded);
  CHECK_THROWS_AS(cut(sphere(1), {0, 0, 0}, 0), Error);
  CHECK_THROWS_AS(cut(sphere(1), {0, 0, NAN}, 0), Error);
  CHECK_THROWS_AS(cut(sphere(1), {0, 0, 1}, HUGE_VAL), Error);
}

TEST_CASE("Loops that touch in a corner stay apart") {
  const Section s = cut(box({1, 1, 1}) + transformed(box({1, 1, 1}), translation({1, 1, 0})), {0, 0, 1}, 0.5);
  CHECK(s.loops.size() == 2);
  CHECK(holds(s.area, 2));
  check_loops(s, 2);
}

TEST_CASE("Sections of random solids: areas as counted by points, closed loops, the inside on the left") {
  RandomSolids random(41);
  for (int round = 0; round < 60; ++round) {
    const Scene scene = compile(random.tree(1 + round % 6));
    const Plane plane{random.direction(), random.number(-0.5, 0.5)};
    const Section s = section(scene, plane);
    if (!s.is_bounded) continue;
    INFO("round " << round);
    CHECK(s.area.error <= 1e-3 * (s.area.value + 1e-3));
    check_loops(s, 30);
    Caster caster(scene);
    // Across the middle of each arc: inside on its left, outside on its right.
    const auto place = [&](PlanePoint p) { return s.origin + p.u * s.u + p.v * s.v; };
    for (const SectionLoop& loop : s.loops) {
      for (const SectionArc& arc : loop) {
        const auto& k = arc.conic;
        const double gu = 2 * k[0] * arc.middle.u + k[1] * arc.middle.v + k[3];
        const double gv = k[1] * arc.middle.u + 2 * k[2] * arc.middle.v + k[4];
        const double size = std::hypot(gu, gv);
        const double chord = std::hypot(arc.to.u - arc.from.u, arc.to.v - arc.from.v);
        if (chord < 1e-3 || size < 1e-3) continue;
        const double step = 1e-7;
        const PlanePoint one{arc.middle.u + step * gu / size, arc.middle.v + step * gv / size};
        const PlanePoint other{arc.middle.u - step * gu / size, arc.middle.v - step * gv / size};
        const Location a = caster.locate(place(one));
        const Location b = caster.locate(place(other));
        CHECK(a != b);
      }
    }
  }
}
