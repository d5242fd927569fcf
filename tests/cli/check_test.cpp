// SPDX-License-Identifier: MIT
#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_CASE("check tells of overlaps with a place, of empty and unbounded parts, and of what is without effect") {
  const TemporaryFolder folder;
  folder.write("scene.csg",
               "part(\"a\") { cube(2); }\n"
               "part(\"b\") { translate([1, 0, 0]) { cube(2); } }\n"
               "part(\"c\") { translate([0, 2, 0]) { cube(2); } }\n"
               "part(\"none\") { intersection() { cube(1); translate([5, 0, 0]) { cube(1); } } }\n"
               "part(\"ground\") { halfspace([0, 0, 1], -3); }\n"
               "translate([0.5, 0.5, 0.5]) { sphere(0.25, $fn = 40); }");
  const Outcome outcome = run(folder, {"check", "scene.csg"});
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.out, "overlap     a and b  volume 4 ±"));
  CHECK_FALSE(contains(outcome.out, "a and c"));
  CHECK_FALSE(contains(outcome.out, "undecided"));
  CHECK(contains(outcome.out, "empty       part none\n"));
  CHECK(contains(outcome.out, "unbounded   part ground may be\n"));
  CHECK(contains(outcome.out, "no effect   intersection at 4:16: nothing is in it\n"));
  CHECK(contains(outcome.out, "no effect   sphere at 6:30: without it the shape is the same\n"));
  CHECK(contains(outcome.out, "welded      nothing\n"));
  const std::string json = run(folder, {"check", "scene.csg", "--format", "json"}).out;
  for (const char* key :
       {"overlaps", "undecided", "unbounded", "empty", "unbounded_parts", "empty_parts", "without_effect",
        "looked_for_redundancy", "welded", "volume", "volume_error", "witness", "parts"})
    CHECK(contains(json, std::string("\"") + key + "\": "));
  CHECK(contains(json, "\"parts\": [\"a\", \"b\"]"));
}

TEST_CASE("check writes a file whole, and nothing where the scene is bad") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "cube(1);");
  folder.write("bad.csg", "cube(1");
  CHECK(run(folder, {"check", "scene.csg", "-o", "report.txt"}).out.empty());
  CHECK(contains(folder.read("report.txt"), "found       0 overlaps among 0 parts; 0 statements without effect\n"));
  CHECK(run(folder, {"check", "bad.csg", "-o", "report.txt"}).exit_code == 2);
  CHECK(contains(folder.read("report.txt"), "found       0 overlaps"));
}

}  // namespace
