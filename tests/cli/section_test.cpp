// SPDX-License-Identifier: MIT
#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_CASE("section as JSON: area, perimeter, and loops of lines and conics") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "difference() { cube(2); cylinder(h = 9, r = 0.5, $fn = 40, center = true); }");
  const Outcome outcome = run(folder, {"section", "scene.csg", "--plane", "0,0,1,1"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  for (const char* key : {"unbounded", "origin", "u", "v", "area", "area_error", "perimeter", "perimeter_error",
                          "place_error", "closed", "loops", "kind", "from", "middle", "to", "conic", "surface"})
    CHECK(contains(outcome.out, std::string("\"") + key + "\": "));
  CHECK(contains(outcome.out, "\"area\": 3.8036504"));
  CHECK(contains(outcome.out, "\"kind\": \"line\""));
  CHECK(contains(outcome.out, "\"kind\": \"conic\""));
}

TEST_CASE("section as SVG: one filled path with arcs") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "difference() { cube(2); cylinder(h = 9, r = 0.5, $fn = 40, center = true); }");
  CHECK(run(folder, {"section", "scene.csg", "--plane", "0,0,1,1", "-o", "cut.svg"}).exit_code == 0);
  const std::string svg = folder.read("cut.svg");
  CHECK(svg.rfind("<?xml", 0) == 0);
  CHECK(contains(svg, "fill-rule=\"evenodd\""));
  CHECK(contains(svg, "A0.5 0.5 0 0 "));
  CHECK(contains(svg, "<desc>Area 3.80365"));
}

TEST_CASE("section as an image: rows of pixels, as dark as they are inside") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "difference() { cube(2); cylinder(h = 9, r = 0.5, $fn = 40, center = true); }");
  CHECK(run(folder, {"section", "scene.csg", "--plane", "0,0,1,0", "-o", "cut.png", "--size", "64"}).exit_code == 0);
  CHECK(folder.read("cut.png").substr(1, 3) == "PNG");
  CHECK(run(folder, {"section", "scene.csg", "--plane", "0,0,1,1", "-o", "cut.png", "--size", "0"}).exit_code == 2);
}

TEST_CASE("section refuses what makes no sense, and leaves the output alone") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "cube(1);");
  folder.write("ground.csg", "halfspace([0, 0, 1], 0);");
  folder.write("cut.svg", "kept");
  const auto refused = [&](const std::vector<std::string>& arguments) {
    const Outcome outcome = run(folder, arguments);
    CHECK(outcome.exit_code == 2);
    CHECK_FALSE(outcome.err.empty());
    CHECK(folder.read("cut.svg") == "kept");
  };
  refused({"section", "scene.csg", "-o", "cut.svg"});
  refused({"section", "scene.csg", "--plane", "0,0,0,1", "-o", "cut.svg"});
  refused({"section", "scene.csg", "--plane", "0,0,1", "-o", "cut.svg"});
  refused({"section", "scene.csg", "--plane", "0,0,nan,1", "-o", "cut.svg"});
  refused({"section", "scene.csg", "--plane", "0,0,1,0.5", "--relative-error", "2", "-o", "cut.svg"});
  refused({"section", "scene.csg", "--plane", "0,0,1,0.5", "-o", "cut.dxf"});
  refused({"section", "ground.csg", "--plane", "1,0,0,0.5", "-o", "cut.svg"});
  CHECK(contains(run(folder, {"section", "ground.csg", "--plane", "1,0,0,0.5"}).out, "\"unbounded\": true"));
}

}  // namespace
