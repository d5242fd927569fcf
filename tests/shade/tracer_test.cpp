// SPDX-License-Identifier: MIT
#include <cmath>

#include "tests/shade/pictures.h"

using namespace csgcast;
using namespace csgcast::test;

namespace {

Material glowing(Rgb emission) {
  Material m = mirror(0);
  m.emission = emission;
  return m;
}

// Two mirrors that face each other, at x = -1 and x = 1.
Solid mirrors(double reflection) {
  return painted(halfspace({1, 0, 0}, -1) + halfspace({-1, 0, 0}, -1), mirror(reflection));
}

}  // namespace

TEST_CASE("a ray that meets nothing shows the background, an empty scene shows nothing else") {
  require_close(Stage(Solid()).trace({0, 0, 0}, {1, 2, 3}), {1, 0.5, 0.25}, 0);
  require_close(Stage(sphere(1)).trace({0, 0, 2}, {0, 0, 1}), {1, 0.5, 0.25}, 0);
}

TEST_CASE("a mirror shows what is where the angle of reflection points") {
  const Solid target = painted(at(sphere(0.5), {4, 0, 4}), glowing({0.25, 0.5, 0.75}));
  Stage stage(painted(halfspace({0, 0, 1}, 0), mirror(0.5)) + target);
  require_close(stage.trace({-4, 0, 4}, {1, 0, -1}), {0.125, 0.25, 0.375}, 0);
  require_close(stage.trace({-4, 0, 4}, {1, 0.2, -1}), 0.5 * stage.view.background, 0);
  const RayTree tree = stage.tree({-4, 0, 4}, {1, 0, -1});
  REQUIRE(tree.size() == 2);
  REQUIRE(tree[0].t == Approx(std::sqrt(32.0)).epsilon(1e-14));
  REQUIRE(tree[1].kind == RayKind::reflection);
  REQUIRE(tree[1].t == Approx(std::sqrt(32.0) - 0.5).epsilon(1e-14));
}

TEST_CASE("at the maximal depth a ray returns the background") {
  Stage stage(mirrors(0.5));
  stage.view.settings.min_contribution = 0;
  for (int depth = 0; depth < 6; ++depth) {
    stage.view.settings.max_depth = depth;
    require_close(stage.trace({0, 0, 0}, {1, 0, 0}), std::pow(0.5, depth) * stage.view.background, 0);
    REQUIRE(stage.report.rays.primary + stage.report.rays.reflection == static_cast<std::uint64_t>(depth));
    REQUIRE(stage.report.skipped.depth_limit == 1);
  }
}

TEST_CASE("a ray that could bring less than min_contribution is not traced") {
  Stage stage(mirrors(0.5));
  stage.view.settings = {100, 1.0 / 16};  // (1/2)^4 is not less, (1/2)^5 is
  require_close(stage.trace({0, 0, 0}, {1, 0, 0}), {}, 0);
  REQUIRE(stage.report.rays.reflection == 4);
  REQUIRE(stage.report.skipped.reflection_below_cutoff == 1);
}

TEST_CASE("mirrors that lose nothing end all the same, however deep they are asked to be followed") {
  Stage stage(mirrors(1));
  stage.view.settings = {1 << 30, 0};
  require_close(stage.trace({0, 0, 0}, {1, 0, 0}), stage.view.background, 0);
  REQUIRE(stage.report.rays.reflection <= 4096);
}

TEST_CASE("a light source is seen by its emission") {
  require_close(Stage(painted(sphere(1), glowing({3, 2, 1}))).trace({0, 0, 5}, {0, 0, -1}), {3, 2, 1}, 0);
}

TEST_CASE("a camera inside an opaque solid sees the inside of its boundary, lit by a light in there") {
  Stage stage(painted(box({4, 4, 4}, Centering::centered), matte()), {point_light({1, 0, 0})});
  REQUIRE(stage.trace({0, 0, 0}, {1, 0, 0}).r == 1);
  REQUIRE(stage.trace({0, 0, 0}, {-1, 0, 0}).r == 1);
  REQUIRE(stage.trace({0, 0, 0}, {0, 0, 1}).r == Approx(2 / std::sqrt(5.0)).epsilon(1e-14));
  // A light outside does not reach it.
  Stage dark(painted(box({4, 4, 4}, Centering::centered), matte()), {point_light({10, 0, 0})});
  REQUIRE(dark.trace({0, 0, 0}, {1, 0, 0}).r == 0);
}

TEST_CASE("a camera inside an opaque solid sees the same if there is glass elsewhere") {
  const Solid solid =
      painted(box({4, 4, 4}, Centering::centered), matte()) + painted(at(sphere(1), {9, 9, 9}), clear_glass(1.5));
  Stage stage(solid, {point_light({1, 0, 0})});
  REQUIRE(stage.trace({0, 0, 0}, {1, 0, 0}).r == 1);
  REQUIRE(stage.trace({0, 0, 0}, {0, 0, 1}).r == Approx(2 / std::sqrt(5.0)).epsilon(1e-14));
}

TEST_CASE("what the rays of a tree bring adds up to the pixel") {
  Material shiny = matte();
  shiny.ambient = 0.2;
  shiny.reflection = 0.4;
  Material glass = clear_glass(1.5, {0.3, 0.1, 0.2});
  glass.specular = 0.5;
  glass.reflection = 0.1;
  glass.transmission = 0.85;
  Stage stage(
      painted(halfspace({0, 0, 1}, -2), shiny) + painted(sphere(1), glass) + painted(at(sphere(1), {2, 1, 0}), shiny),
      {point_light({-4, -5, 8}), sun({-1, 0, -1})});
  for (const double x : {-0.9, -0.4, 0.0, 0.3, 0.8, 1.5, 2.5}) {
    RayTree tree;
    const Rgb color = stage.trace({x, -8, 0.6}, {0.02, 1, -0.08}, &tree);
    REQUIRE(tree.size() >= 3);
    Rgb sum;
    for (const RayRecord& ray : tree) {
      if (ray.kind != RayKind::shadow) sum = sum + ray.brings;
    }
    require_close(sum, color, 1e-15 * static_cast<double>(tree.size()));
  }
}

TEST_CASE("a pixel's tree prints a line for each ray, children indented below their parent") {
  Stage stage(painted(halfspace({0, 0, 1}, 0).at({"a.csg", 3, 7}), mirror(0.5)), {sun({0, 0, -1})});
  const std::string text = to_string(stage.tree({0, 0, 2}, {0, 0, -1}), stage.scene);
  REQUIRE(text ==
          "primary hits a.csg:3:7 halfspace (look 1) at t 2 on surface 0 (plane), weight [1 1 1], brings [0 0 0]\n"
          "  shadow to light 1 not traced: adds nothing\n"
          "  reflection leaves: background, weight [0.5 0.5 0.5], brings [0.5 0.25 0.125]\n");
}
