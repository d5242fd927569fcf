// SPDX-License-Identifier: MIT
#include <algorithm>

#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;

constexpr const char* scene = R"(camera(eye = [9, -9, 6], look_at = [0, 0, 0]);
light(position = [5, 5, 9], intensity = 0.5);
part("body", density = 2.5) {
  difference() {
    cube(2);
    cylinder(h = 2, r = 0.5);
  }
}
multmatrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0], [0, 0, 0, 1]]) { sphere(r = 1); }
color("red", 0.5) { sphere(r = 0.25); }
)";

/// The text up to what differs from run to run.
std::string before_seconds(const std::string& text) { return text.substr(0, text.find("seconds")); }

TEST_CASE("info tells what a scene holds") {
  const TemporaryFolder folder;
  folder.write("scene.csg", scene);
  const Outcome outcome = run(folder, {"info", "scene.csg"});
  CHECK(outcome.exit_code == 0);
  CHECK(before_seconds(outcome.out) == R"(file        scene.csg
statements  10: camera 1, color 1, cube 1, cylinder 1, difference 1, light 1, multmatrix 1, part 1, sphere 2
depth       3
leaves      3: cube 1, cylinder 1, sphere 1
surfaces    8: planes 6, quadrics 2; shared by several leaves 2
quadrics    circular cylinder 1, sphere 1
welded      nothing
tree        5 nodes after simplification, leaves included
parts       1
            body at 3:1  density 2.5  leaves 2
regions     2 (runs of one part and look)
looks       2, some let light through
bounds      -0.25, -0.25, -0.25  to  2, 2, 2  (size 2.25, 2.25, 2.25)
camera      eye 9, -9, 6  look at 0, 0, 0  up 0, 0, 1  field of view 30
lights      1
            at 5, 5, 9  color 1, 1, 1  intensity 0.5
background  default
settings    max_depth 5, min_contribution 0.001953125
warnings    1
)");
  CHECK(outcome.err.substr(0, outcome.err.find(" warning:")) == "scene.csg:9:1:");
}

TEST_CASE("info as JSON tells the kind, place and size of each quadric") {
  const TemporaryFolder folder;
  folder.write("scene.csg", R"(translate([1, 2, 3]) { sphere(r = 2, $fn = 50); }
translate([9, 0, 0]) { rotate([90, 0, 0]) { cylinder(h = 2, r = 0.5); } }
translate([0, 0, 20]) { cylinder(h = 2, r1 = 2, r2 = 0); }
)");
  const std::string json = run(folder, {"info", "scene.csg", "--format", "json"}).out;
  const auto has = [&](const std::string& part) {
    INFO(part << " in " << json);
    CHECK(json.find(part) != std::string::npos);
  };
  has(R"("quadrics_by_kind": {"circular cone": 1, "circular cylinder": 1, "sphere": 1})");
  has(R"("kind": "sphere", "center": [1, 2, 3], "axes": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "axes_error": [null, null, null], "semi_axes": [2, 2, 2], "relative_error": )");
  has(R"("kind": "circular cylinder", "center": [9, 0, 0])");
  has(R"("semi_axes": [0.5, 0.5, null])");
  has(R"("kind": "circular cone", "center": [0, 0, 22])");
  has(R"("half_angles": [45, 45])");
}

TEST_CASE("info as JSON") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "part(\"a\\\\\\n\\\"b\") { halfspace(n = [0, 0, 1], d = 2); }");
  const Outcome outcome = run(folder, {"info", "scene.csg", "--format", "json"});
  CHECK(outcome.exit_code == 0);
  CHECK(before_seconds(outcome.out) == R"({
  "file": "scene.csg",
  "statements": 2,
  "depth": 2,
  "statements_by_name": {"halfspace": 1, "part": 1},
  "unsupported": [],
  "faceted": 0,
  "leaves": 1,
  "leaves_by_kind": {"halfspace": 1},
  "surfaces": {"planes": 1, "quadrics": 0, "shared": 0},
  "quadrics_by_kind": {},
  "quadrics": [],
  "welded": {
    "surfaces": 0,
    "clusters": 0,
    "widest": 0,
    "incomplete": false,
    "near_miss_count": 0,
    "suggested_tolerance": 0,
    "near_misses": []
  },
  "nodes": 1,
  "parts": [
    {"name": "a\\\u000a\"b", "density": 1, "place": "1:1", "leaves": 1}
  ],
  "regions": 1,
  "looks": 1,
  "transmits": false,
  "bounds": {"empty": false, "unbounded": true, "lower": [null, null, null], "upper": [null, null, 2]},
  "camera": null,
  "lights": [],
  "background": null,
  "settings": {"max_depth": 5, "min_contribution": 0.001953125, "digits": 17},
  "warnings": [],
  ")");
}

TEST_CASE("the option --quiet keeps warnings back, and info still counts them") {
  const TemporaryFolder folder;
  folder.write("scene.csg", scene);
  const Outcome outcome = run(folder, {"info", "scene.csg", "--quiet"});
  CHECK(outcome.err.empty());
  CHECK(outcome.out.find("warnings    1\n") != std::string::npos);
}

TEST_CASE("the option --facets decides which curved solids become polyhedra") {
  const TemporaryFolder folder;
  folder.write("scene.csg",
               "cylinder(h = 1, r = 1, $fn = 6);\ntranslate([5, 0, 0]) { cylinder(h = 1, r = 1, $fn = 20); }");
  const auto surfaces = [&](const std::string& facets) {
    const std::string out = run(folder, {"info", "scene.csg", "--facets", facets}).out;
    const std::size_t start = out.find("planes");
    return out.substr(start, out.find(';', start) - start);
  };
  // Both cylinders stand on the planes z = 0 and z = 1; each facet has a plane.
  CHECK(surfaces("never") == "planes 2, quadrics 2");
  CHECK(surfaces("auto") == "planes 8, quadrics 1");
  CHECK(surfaces("always") == "planes 28, quadrics 0");
}

TEST_CASE("the option --weld decides which faces become one, and info tells") {
  const TemporaryFolder folder;
  // A brick that stands on 0.1 + 0.2, as 0.3, and one a millionth beside it.
  folder.write("scene.csg",
               "cube([1, 1, 0.30000000000000004]);\ntranslate([0, 0, 0.3]) { cube(1); }\n"
               "translate([1.000001, 0, 0.3]) { cube(1); }");
  const auto rows = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"info", "scene.csg"});
    const std::string out = run(folder, more).out;
    return out.substr(out.find("surfaces"), out.find("tree") - out.find("surfaces"));
  };
  CHECK(rows({}) == R"(surfaces    9: planes 9, quadrics 0; shared by several leaves 6
welded      1 surface joined 1 other; moved by at most 5.55e-17 (relative 2.15e-17)
near misses 1 pair of surfaces, not one but near; --weld 4.83e-07 would join them, but for wider ones
            1:1 and 3:33  gap 1e-06 (relative 3.87e-07)
)");
  CHECK(rows({"--weld", "0"}) == R"(surfaces    10: planes 10, quadrics 0; shared by several leaves 6
welded      nothing
)");
  CHECK(rows({"--weld", "4.83e-07"}) == R"(surfaces    8: planes 8, quadrics 0; shared by several leaves 6
welded      2 surfaces joined 2 others; moved by at most 1e-06 (relative 3.87e-07)
)");
  for (const char* wrong : {"-1", "0.5", "nan", "inf", "x", ""}) {
    CAPTURE(wrong);
    const Outcome outcome = run(folder, {"info", "scene.csg", "--weld", wrong});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find("--weld") != std::string::npos);
  }
}

TEST_CASE("a crack of 1e-16 shows as two intervals unless it is welded") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "cube([1, 1, 0.3]);\ntranslate([0, 0, 0.30000000000000004]) { cube(1); }");
  const auto rows = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"intervals", "scene.csg", "--ray", "0.5,0.5,-1,0,0,1", "--format", "csv"});
    const std::string out = run(folder, more).out;
    return std::count(out.begin(), out.end(), '\n') - 1;
  };
  CHECK(rows({}) == 1);
  CHECK(rows({"--weld", "0"}) == 2);
}

TEST_CASE("info and measure tell of round solids that became polyhedra, info of what is not supported") {
  const TemporaryFolder folder;
  folder.write("a.csg", "sphere(1, $fn = 8);\ncylinder(h = 1, r = 1, $fn = 6);\nsphere(3, $fn = 100);\n");
  const std::string facets =
      "facets      2 round solids are polyhedra, as $fn says (--facets never keeps them round)\n";
  CHECK(run(folder, {"info", "a.csg"}).out.find(facets) != std::string::npos);
  CHECK(run(folder, {"measure", "a.csg"}).out.find(facets) != std::string::npos);
  CHECK(run(folder, {"info", "a.csg", "--facets", "never"}).out.find("facets") == std::string::npos);
  folder.write("b.csg", "hull() { cube(1); }\ncube(2);\ntext(\"a\"); hull();\n");
  const Outcome outcome = run(folder, {"info", "b.csg", "--quiet"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find("left out    hull 2, not supported yet: lines 1, 3\n") != std::string::npos);
  CHECK(outcome.out.find("left out    text 1, not supported yet: line 3\n") != std::string::npos);
  const Outcome refused = run(folder, {"measure", "b.csg"});
  CHECK(refused.exit_code == 2);
  CHECK(refused.err.find("nor those of 2 more statements") != std::string::npos);
  const Outcome skipped = run(folder, {"measure", "b.csg", "--skip-unsupported"});
  CHECK(skipped.exit_code == 0);
  CHECK(skipped.err.find("b.csg:1:1: warning: 'hull' is left out: it is not supported yet\n") != std::string::npos);
}

}  // namespace
