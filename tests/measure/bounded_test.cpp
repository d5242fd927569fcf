// SPDX-License-Identifier: MIT
// Solids between unbounded leaves: whether they are bounded, and their volumes.
#include <cmath>
#include <string>
#include <vector>

#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"
#include "measure/measure.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

using namespace csgcast;

namespace {

struct Bounded {
  std::string text;
  double volume;
};

const std::string slab = "halfspace([0, 0, 1], 10); halfspace([0, 0, -1], 0); ";
const std::string tube = "quadric([[1, 0, 0], [0, 1, 0], [0, 0, 0]], [0, 0, 0], -1); ";
const std::string bowl = "quadric([[1, 0, 0], [0, 1, 0], [0, 0, 0]], [0, 0, -1], 0); ";
const std::string cone = "quadric([[1, 0, 0], [0, 1, 0], [0, 0, -0.25]], [0, 0, 0], 0); ";
const std::string ball = "quadric([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 0], -1); ";
const std::string corner = "halfspace([-1, 0, 0], 0); halfspace([0, -1, 0], 0); halfspace([0, 0, -1], 0); ";

std::string both(const std::string& children) { return "intersection() { " + children + "} "; }
std::string less(const std::string& children) { return "difference() { " + children + "} "; }
std::string all_but(const std::string& children) { return "complement() { " + children + "} "; }

const std::vector<Bounded>& bounded_solids() {
  static const std::vector<Bounded> solids{
      {both(cone + slab), 250 * M_PI / 3},
      {both(tube + slab), 10 * M_PI},
      {both(bowl + slab), 50 * M_PI},
      {both("quadric([[1, 0, 0], [0, 1, 0], [0, 0, -1]], [0, 0, 0], -1); halfspace([0, 0, 1], 10); "
            "halfspace([0, 0, -1], 10);"),
       M_PI * (20 + 2000.0 / 3)},
      {both(corner + "halfspace([1, 1, 1], 3);"), 4.5},
      {both(corner + "halfspace([1, 0, 0], 1); halfspace([0, 1, 0], 2); halfspace([0, 0, 1], 3);"), 6},
      // Opposing paraboloids touch at infinity.
      {both(bowl + "quadric([[1, 0, 0], [0, 1, 0], [0, 0, 0]], [0, 0, 1], -8);"), 16 * M_PI},
      {both(bowl + "halfspace([0, 0, 1], 4);"), 8 * M_PI},
      // Cylinders across each other.
      {both(tube + "quadric([[1, 0, 0], [0, 0, 0], [0, 0, 1]], [0, 0, 0], -1);"), 16.0 / 3},
      // Cones that face each other.
      {both("quadric([[1, 0, 0], [0, 1, 0], [0, 0, -1]], [0, 0, 0], 0); translate([0, 0, 4]) { quadric([[1, 0, 0], [0, "
            "1, 0], [0, 0, -1]], [0, 0, 0], 0); } halfspace([0, 0, -1], 0); halfspace([0, 0, 1], 4);"),
       16 * M_PI / 3},
      {all_but(all_but(ball)), 4 * M_PI / 3},
      {all_but(
           "halfspace([1, 0, 0], 0); halfspace([0, 1, 0], 0); halfspace([0, 0, 1], 0); halfspace([-1, -1, -1], -3);"),
       4.5},
      {both(tube + slab + all_but("quadric([[4, 0, 0], [0, 4, 0], [0, 0, 0]], [0, 0, 0], -1);")), 7.5 * M_PI},
      {less(both(tube + slab) + "quadric([[4, 0, 0], [0, 4, 0], [0, 0, 0]], [0, 0, 0], -1);"), 7.5 * M_PI},
      {less(tube + "halfspace([0, 0, 1], 0); halfspace([0, 0, -1], -10);"), 10 * M_PI},
      {less("halfspace([0, 0, 1], 10); halfspace([0, 0, 1], 0); " +
            all_but("quadric([[1, 0, 0], [0, 1, 0], [0, 0, 0]], [0, 0, 0], -1);")),
       10 * M_PI},
      {"union() { " + both(tube + slab) + both("translate([5, 0, 0]) { " + tube + "} " + slab) + "}", 20 * M_PI},
      {"union() { " + both(tube + slab) + "translate([5, 0, 0]) { cube(2); } }", 10 * M_PI + 8},
      // Empty, though both reach to infinity.
      {both("halfspace([0, 0, 1], 0); halfspace([0, 0, -1], -1);"), 0},
      {both("halfspace([0, 0, 1], -1); " + bowl), 0},
      {less(slab + "halfspace([0, 0, 1], 20);"), 0},
  };
  return solids;
}

const std::vector<std::string>& unbounded_solids() {
  static const std::vector<std::string> solids{
      "halfspace([0, 0, 1], 0);",
      slab,
      both(slab),
      tube,
      bowl,
      cone,
      all_but(ball),
      all_but("cube(1);"),
      both(corner),
      // Parallel cylinders that overlap.
      both(tube + "translate([1, 0, 0]) { " + tube + "}"),
      less(tube + "translate([1, 0, 0]) { " + tube + "}"),
      // A cone cut parallel to a generator.
      both("quadric([[1, 0, 0], [0, 1, 0], [0, 0, -1]], [0, 0, 0], 0); halfspace([0, 0, -1], 0); halfspace([-1, 0, 1], "
           "1);"),
      both(tube + "halfspace([0, 0, 1], 0);"),
      both(bowl + "halfspace([0, 0, -1], -4);"),
      both(bowl + "halfspace([1, 0, 0], 0);"),
      // A prism, a wedge, a hyperbolic paraboloid between planes.
      both("halfspace([-1, 0, 0], 0); halfspace([0, -1, 0], 0); halfspace([1, 1, 0], 1);"),
      both("halfspace([0, 0, -1], 0); halfspace([-0.001, 0, 1], 0);"),
      both("quadric([[1, 0, 0], [0, -1, 0], [0, 0, 0]], [0, 0, -1], 0);" + slab),
      "union() { sphere(1); " + tube + "}",
      less(slab + "sphere(3);"),
      both("quadric([[1, 0, 0], [0, 1, 0], [0, 0, -1]], [0, 0, 0], 1); halfspace([0, 0, -1], 0);"),
  };
  return solids;
}

struct Placement {
  std::string statement;
  double volume;  // that a unit of volume has there
};

const std::vector<Placement>& placements() {
  static const std::vector<Placement> all{{"union()", 1},
                                          {"translate([1e6, -2e6, 3e6])", 1},
                                          {"scale(1e-6)", 1e-18},
                                          {"rotate([10, 20, 30])", 1},
                                          {"translate([100, 0, 0]) rotate([50, 60, 70]) scale([1, 2, 3])", 6}};
  return all;
}

Scene compiled(const std::string& text) { return compile(text::build(text::read(text, "a.csg")).solid); }

}  // namespace

TEST_CASE("Solids between unbounded leaves are bounded where they are, with their volumes") {
  for (std::size_t i = 0; i < bounded_solids().size() * placements().size(); i += test::stride) {
    const Bounded& solid = bounded_solids()[i / placements().size()];
    const Placement& placement = placements()[i % placements().size()];
    const std::string text = placement.statement + " { " + solid.text + " }";
    INFO(text);
    const Scene scene = compiled(text);
    REQUIRE_FALSE(scene.opening());
    REQUIRE((scene.bounds().is_null() || scene.bounds().is_finite()));
    const Measures m = measure(scene).whole;
    REQUIRE(m.is_bounded);
    const double volume = solid.volume * placement.volume;
    CHECK(std::fabs(m.volume.value - volume) <= m.volume.error + 1e-13 * volume);
    CHECK(m.volume.error <= 1e-3 * volume + 1e-300);
    // The box is not far from the tightest one, which measuring finds.
    if (volume == 0) continue;
    const Vector tight = m.bounds.size(), wide = scene.bounds().size();
    for (std::size_t axis = 0; axis < 3; ++axis) CHECK(wide[axis] <= 1.5 * tight[axis]);
  }
}

TEST_CASE("Solids that reach to infinity say where") {
  for (std::size_t i = 0; i < unbounded_solids().size() * placements().size(); i += test::stride) {
    const std::string text =
        placements()[i % placements().size()].statement + " { " + unbounded_solids()[i / placements().size()] + " }";
    INFO(text);
    const Scene scene = compiled(text);
    REQUIRE_FALSE(scene.bounds().is_finite());
    REQUIRE(scene.opening());
    CHECK(scene.opening()->direction != Vector{});
    CHECK_FALSE(measure(scene).whole.is_bounded);
  }
}

TEST_CASE("Where a solid is certainly open there are points of it as far away as one likes") {
  const Scene scene = compiled(both(corner));
  REQUIRE(scene.opening());
  CHECK(scene.opening()->is_certain);
  const Vector d = scene.opening()->direction;
  CHECK(d.x >= 0);
  CHECK(d.y >= 0);
  CHECK(d.z >= 0);
  CHECK_FALSE(compiled(tube).opening()->is_certain);
  CHECK(std::fabs(compiled(tube).opening()->direction.z) == 1);
}
