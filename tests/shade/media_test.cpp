// SPDX-License-Identifier: MIT
#include <cmath>

#include "shade/light/phong.h"
#include "tests/shade/pictures.h"

using namespace csgcast;
using namespace csgcast::test;

namespace {

Solid slab(double bottom, double top) { return block({-50, -50, bottom}, {50, 50, top}); }

Solid part_of(Solid solid, const char* name) { return named(std::move(solid), PartName{name, 1}); }

// The hits of the rays that go through, from the first.
std::vector<RayRecord> path(Stage& stage, Point from, Vector direction) {
  std::vector<RayRecord> hits;
  for (const RayRecord& ray : stage.tree(from, direction)) {
    if (ray.kind != RayKind::shadow && ray.fate == Fate::hit) hits.push_back(ray);
  }
  return hits;
}

}  // namespace

TEST_CASE("through a slab of glass a ray is bent in and out again, and arrives shifted sideways") {
  // In at 45 degrees: inside the sine is sqrt(1/2) / 1.5, and what comes out goes on at 45 degrees to a floor 3 below.
  Stage stage(painted(slab(0, 2), clear_glass(1.5)) + painted(halfspace({0, 0, 1}, -3), matte()));
  const std::vector<RayRecord> hits = path(stage, {0, 0, 3}, {1, 0, -1});
  REQUIRE(hits.size() == 3);
  const double sine = std::sqrt(0.5) / 1.5;
  REQUIRE(hits[0].t == Approx(std::sqrt(2.0)).epsilon(1e-14));
  REQUIRE(hits[1].t == Approx(2 / std::sqrt(1 - sine * sine)).epsilon(1e-14));
  REQUIRE(hits[2].t == Approx(3 * std::sqrt(2.0)).epsilon(1e-13));
}

TEST_CASE("a right-angled prism of glass turns a ray by total internal reflection") {
  // Legs on x = 0 and z = 0, hypotenuse x + z = 2; in through z = 0 head-on, out through x = 0 head-on.
  const Solid prism = intersect({block({0, -1, 0}, {2, 1, 2}), halfspace({1, 0, 1}, 2)});
  Stage stage(painted(prism, clear_glass(1.5, {1, 0, 0})));
  const RayTree tree = stage.tree({0.5, 0, -1}, {0, 0, 1});
  REQUIRE(tree.size() == 4);
  REQUIRE(tree[1].kind == RayKind::transmission);
  REQUIRE(tree[1].t == Approx(1.5).epsilon(1e-14));
  REQUIRE(tree[2].kind == RayKind::reflection);
  REQUIRE(tree[2].total);
  REQUIRE(tree[2].t == Approx(0.5).epsilon(1e-14));
  REQUIRE(tree[3].kind == RayKind::transmission);
  REQUIRE(tree[3].fate == Fate::left);
  require_close(tree[3].brings, stage.view.background * Rgb{std::exp(-2), 1, 1});
  REQUIRE(stage.report.total_reflections == 1);
  // Of water (critical angle 48.6 degrees) it lets the ray out.
  Stage water(painted(prism, clear_glass(1.333)));
  REQUIRE(water.tree({0.5, 0, -1}, {0, 0, 1}).size() == 3);
  REQUIRE(water.report.total_reflections == 0);
}

TEST_CASE("a medium absorbs exponentially with the length of the path in it") {
  for (const double thickness : {0.1, 1.0, 7.0}) {
    const Rgb absorption{0.5, 0.1, 0};
    Stage stage(painted(slab(0, thickness), clear_glass(1, absorption)));
    require_close(stage.trace({0, 0, 10}, {0, 0, -1}), stage.view.background * transmittance(absorption, thickness));
    require_close(stage.trace({0, 0, 10}, {1, 0, -1}),
                  stage.view.background * transmittance(absorption, thickness * std::sqrt(2.0)));
  }
}

TEST_CASE("each face takes its share: transmission counts at every one") {
  Material glass = clear_glass(1.5);
  glass.transmission = 0.8;
  Stage stage(painted(slab(0, 1), glass) + painted(slab(2, 3), glass));
  require_close(stage.trace({0, 0, 10}, {0, 0, -1}), 0.8 * 0.8 * 0.8 * 0.8 * stage.view.background);
}

TEST_CASE("glass on water is two media, and between them Snell's law holds with both indices") {
  Stage stage(part_of(painted(slab(0, 2), clear_glass(1.5, {1, 0, 0})), "glass") +
              part_of(painted(slab(-3, 0), clear_glass(1.333, {0, 1, 0})), "water"));
  const std::vector<RayRecord> hits = path(stage, {0, 0, 3}, {1, 0, -1});
  REQUIRE(hits.size() == 3);
  const auto slant = [](double height, double ior) { return height / std::sqrt(1 - 0.5 / (ior * ior)); };
  REQUIRE(hits[1].t == Approx(slant(2, 1.5)).epsilon(1e-14));
  REQUIRE(hits[2].t == Approx(slant(3, 1.333)).epsilon(1e-13));
  const Rgb left{std::exp(-slant(2, 1.5)), std::exp(-slant(3, 1.333)), 1};
  require_close(stage.trace({0, 0, 3}, {1, 0, -1}), stage.view.background * left);
}

TEST_CASE("where media overlap, the first in file order is what the ray is in") {
  const Solid glass = painted(slab(0, 2), clear_glass(1.5, {1, 0, 0}));
  const Solid water = painted(slab(-3, 1), clear_glass(1.333, {0, 1, 0}));
  require_close(Stage(glass + water).trace({0, 0, 3}, {0, 0, -1}),
                Rgb{1, 0.5, 0.25} * Rgb{std::exp(-2), std::exp(-3), 1});
  require_close(Stage(water + glass).trace({0, 0, 3}, {0, 0, -1}),
                Rgb{1, 0.5, 0.25} * Rgb{std::exp(-1), std::exp(-4), 1});
}

TEST_CASE("two pieces of one glass that touch or overlap are one medium without a face between") {
  for (const double top : {1.0, 1.5}) {
    Stage stage(painted(slab(0, top) + slab(1, 2), clear_glass(1.5, {1, 0, 0})));
    REQUIRE(path(stage, {0, 0, 3}, {1, 0, -2}).size() == 2);
  }
}

TEST_CASE("glass that touches an opaque solid ends there, at the opaque solid's face") {
  Material wall = matte();
  wall.ambient = 0.5;
  const Solid glass = painted(slab(0, 2), clear_glass(1.5, {1, 0, 0}));
  const Solid stone = painted(slab(-1, 0), wall);
  for (const Solid& scene : {glass + stone, stone + glass}) {
    Stage stage(scene);
    const RayTree tree = stage.tree({0, 0, 3}, {0, 0, -1});
    REQUIRE(tree.size() == 2);
    REQUIRE(stage.scene.look(tree[1].look) == wall);
    require_close(tree[1].brings, {0.5 * std::exp(-2), 0.5, 0.5});
  }
}

TEST_CASE("an opaque solid with a dent of glass colour is not looked through") {
  const Solid dented =
      painted(box({4, 4, 4}, Centering::centered), matte()) - painted(at(sphere(1), {0, 0, 2}), clear_glass(1.5));
  Stage stage(dented + painted(at(sphere(1), {9, 9, 9}), clear_glass(1.5)));
  const RayTree tree = stage.tree({0, 0, 5}, {0, 0, -1});
  REQUIRE(tree.size() == 1);
  REQUIRE(tree[0].fate == Fate::hit);
  REQUIRE(tree[0].t == Approx(4).epsilon(1e-14));
}

TEST_CASE("a camera under water looks through it") {
  Stage stage(painted(slab(-3, 0), clear_glass(1.333, {0, 1, 0})));
  const RayTree tree = stage.tree({0, 0, -2}, {0, 0, 1});
  REQUIRE(tree.size() == 2);
  require_close(tree[1].brings, stage.view.background * Rgb{1, std::exp(-2), 1});
  // Beyond the critical angle the surface is a mirror.
  stage.view.settings.max_depth = 3;
  const RayTree flat = stage.tree({0, 0, -2}, {2, 0, 1});
  REQUIRE(flat[1].total);
}

TEST_CASE("a ball of glass lens shows the scene behind it upside down") {
  const auto glow = [](Rgb c) {
    Material m = mirror(0);
    m.emission = c;
    return m;
  };
  Stage stage(painted(sphere(1), clear_glass(1.5)) + painted(halfspace({0, -1, -1e-3}, -20), glow({1, 0, 0})));
  stage.view.background = {0, 1, 0};
  // A wall beyond y = 20 all over: both rays arrive there, crossing over on the way.
  const std::vector<RayRecord> above = path(stage, {0, -5, 0.5}, {0, 1, 0});
  const std::vector<RayRecord> below = path(stage, {0, -5, -0.5}, {0, 1, 0});
  REQUIRE(above.size() == 3);
  REQUIRE(below.size() == 3);
  // The wall leans towards the viewer at the top: the ray from above ends low and goes further.
  REQUIRE(above[2].t > below[2].t);
}

TEST_CASE("a cube of glass seen along its edges has no stray rays: every ray through parallel faces arrives") {
  Stage stage(painted(box({2, 2, 2}, Centering::centered), clear_glass(1.5, {1, 1, 1})));
  stage.view.settings.max_depth = 20;
  for (int i = 0; i <= 40; ++i) {
    const double x = -0.999 + i * 0.04995;
    require_close(stage.trace({x, -4, 0.999}, {0, 1, 0}), std::exp(-2) * stage.view.background);
  }
}
