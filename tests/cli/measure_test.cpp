// SPDX-License-Identifier: MIT
#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_CASE("measure as a table: numbers with their errors, then the parts") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "part(\"iron\", density = 7.8) { cube(2); }\ntranslate([5, 0, 0]) { cube(1); }");
  const Outcome outcome = run(folder, {"measure", "scene.csg"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK(contains(outcome.out, "volume      9"));
  CHECK(contains(outcome.out, "mass        63.4"));
  CHECK(contains(outcome.out, "\npart iron, density 7.8\nvolume      8"));
  CHECK(contains(outcome.out, " ± "));
}

TEST_CASE("measure tells principal moments with their axes, or that those are undetermined") {
  const TemporaryFolder folder;
  folder.write("box.csg", "rotate([0, 0, 90]) { cube([1, 2, 3]); }");
  folder.write("ball.csg", "sphere(r = 1, $fn = 50);");
  const std::string box = run(folder, {"measure", "box.csg"}).out;
  INFO(box);
  CHECK(contains(box, "principal   2.5"));
  CHECK(contains(box, "            6.5"));
  CHECK(contains(box, " radians\n"));
  CHECK(!contains(box, "undetermined"));
  CHECK(contains(run(folder, {"measure", "ball.csg"}).out, " about an undetermined axis\n"));
  const std::string json = run(folder, {"measure", "ball.csg", "--format", "json"}).out;
  CHECK(contains(json, "\"axis\": null, \"axis_error\": null}"));
}

TEST_CASE("measure as JSON has every key of the manual") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "part(\"ball\") { sphere(r = 1, $fn = 50); }");
  const Outcome outcome = run(folder, {"measure", "scene.csg", "--format", "json", "--relative-error", "1e-6"});
  CHECK(outcome.exit_code == 0);
  for (const char* key : {"unbounded",      "volume",       "volume_error",  "area",
                          "area_error",     "mass",         "mass_error",    "centroid",
                          "centroid_error", "inertia",      "inertia_error", "principal",
                          "moment",         "axis",         "axis_error",    "principal_error",
                          "bounds",         "bounds_error", "cells",         "as_asked",
                          "seconds",        "parts",        "name",          "density"})
    CHECK(contains(outcome.out, std::string("\"") + key + "\": "));
  CHECK(contains(outcome.out, "\"volume\": 4.1887"));
  CHECK(contains(outcome.out, "\"as_asked\": true"));
}

TEST_CASE("measure of an empty and of an unbounded solid says so") {
  const TemporaryFolder folder;
  folder.write("empty.csg", "intersection() { cube(1); translate([3, 0, 0]) { cube(1); } }");
  folder.write("unbounded.csg", "halfspace(n = [0, 0, 1], d = 0);");
  const Outcome empty = run(folder, {"measure", "empty.csg", "--quiet"});
  CHECK(empty.exit_code == 0);
  CHECK(contains(empty.out, "volume      0\n"));
  CHECK(contains(empty.out, "bounds      empty\n"));
  CHECK(run(folder, {"measure", "unbounded.csg"}).out ==
        "volume      none: the solid is open towards 0, 0, -1 (1:1); measured are parts\n");
  const std::string json = run(folder, {"measure", "unbounded.csg", "--format", "json"}).out;
  CHECK(contains(json, "\"unbounded\": true"));
  CHECK(contains(json, "\"volume\": null"));
}

TEST_CASE("measure refuses errors that are none, and leaves the output alone") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "cube(1);");
  folder.write("out.json", "kept");
  for (const char* error : {"0", "1", "-1e-3", "nan", "inf", "x", "1,2", ""}) {
    const Outcome outcome = run(folder, {"measure", "scene.csg", "--relative-error", error, "-o", "out.json"});
    INFO(error);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, "--relative-error"));
    CHECK(folder.read("out.json") == "kept");
  }
  CHECK(run(folder, {"measure", "scene.csg", "--area-error", "2"}).exit_code == 2);
  CHECK(run(folder, {"measure", "scene.csg", "-o", "scene.csg"}).exit_code == 2);
  CHECK(folder.read("scene.csg") == "cube(1);");
}

TEST_CASE("a part alone is measured as if it were all the scene holds") {
  const TemporaryFolder folder;
  folder.write(
      "scene.csg",
      "part(\"body\", density = 2) { cube(2); }\npart(\"pin, long\") { translate([9, 0, 0]) { cube([1, 1, 4]); } }\n"
      "halfspace([0, 0, 1], -1);");
  const Outcome body = run(folder, {"measure", "scene.csg", "--part", "body", "--format", "json"});
  CHECK(body.exit_code == 0);
  folder.write("body.csg", "part(\"body\", density = 2) { cube(2); }");
  const std::string alone = run(folder, {"measure", "body.csg", "--format", "json"}).out;
  CHECK(body.out.substr(0, body.out.find("seconds")) == alone.substr(0, alone.find("seconds")));
  const Outcome both = run(folder, {"measure", "scene.csg", "--part", "body", "--part", "pin, long"});
  CHECK(contains(both.out, "volume      12 "));
  CHECK(contains(both.out, "part pin, long, density 1"));
  const Outcome nobody = run(folder, {"measure", "scene.csg", "--part", "Body"});
  CHECK(nobody.exit_code == 2);
  CHECK(
      nobody.err ==
      "scene.csg: error: no part is named 'Body' (--part takes the name of a part(\"name\") statement); the parts are "
      "body, pin, long\n");
  folder.write("none.csg", "cube(1);");
  CHECK(contains(run(folder, {"info", "none.csg", "--part", "x"}).err, "name one, or leave --part out"));
}

TEST_CASE("measure says the same on any number of threads") {
  const TemporaryFolder folder;
  folder.write("scene.csg",
               "difference() { sphere(r = 1, $fn = 90); cylinder(h = 4, r = 0.4, center = true, $fn = 90); }");
  const std::string one = run(folder, {"measure", "scene.csg", "--threads", "1"}).out;
  CHECK(one == run(folder, {"measure", "scene.csg", "--threads", "2"}).out);
  CHECK(one == run(folder, {"measure", "scene.csg", "--threads", "8"}).out);
}

}  // namespace
