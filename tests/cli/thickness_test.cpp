// SPDX-License-Identifier: MIT
#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_CASE("thickness tells the thinnest place, and draws a map") {
  const TemporaryFolder folder;
  folder.write("scene.csg",
               "difference() { cube([4, 4, 1]); translate([2, 2, 0.125]) { cylinder(h = 2, r = 0.5, $fn = 40); } }");
  const Outcome outcome = run(folder, {"thickness", "scene.csg", "-o", "map.png", "--size", "40x30", "--grid", "64"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.rfind("thinnest    0.125  at ", 0) == 0);
  CHECK(folder.read("map.png").substr(1, 3) == "PNG");
  const std::string json = run(folder, {"thickness", "scene.csg", "--grid", "64", "--format", "json"}).out;
  for (const char* key : {"thinnest", "thickness", "place", "normal", "leaf"})
    CHECK(contains(json, std::string("\"") + key + "\": "));
  folder.write("ground.csg", "halfspace([0, 0, 1], 0);");
  CHECK(contains(run(folder, {"thickness", "ground.csg"}).out, "none"));
}

TEST_CASE("thickness refuses what makes no sense") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "cube(1);");
  CHECK(run(folder, {"thickness", "scene.csg", "-o", "map.stl"}).exit_code == 2);
  CHECK(run(folder, {"thickness", "scene.csg", "--grid", "0"}).exit_code == 2);
  CHECK(run(folder, {"thickness", "scene.csg", "--size", "0x10"}).exit_code == 2);
  CHECK(run(folder, {"thickness", "scene.csg", "-o", "scene.png", "--camera", "1,2"}).exit_code == 2);
}

}  // namespace
