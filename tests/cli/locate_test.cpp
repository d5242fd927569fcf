// SPDX-License-Identifier: MIT
#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;

struct SceneFolder : TemporaryFolder {
  SceneFolder() {
    write("scene.csg",
          "part(\"left\") { cube(1); }\npart(\"right \\\"R\\\"\") { translate([1, 0, 0]) { cube(1); } }\ntranslate([5, "
          "0, 0]) { cube(1); }");
    // Inside the left part, on its lower face, on the face both share, inside the right part, on what is in no part,
    // outside.
    write("points.csv", "x,y,z\n0.5,0.5,0.5\n0.5,0.5,0\n1,0.5,0.5\n1.5,0.5,0.5\n5,0.5,0.5\n9,9,9\n");
  }
};

TEST_CASE("locate as CSV: inside, outside or boundary, and the part") {
  const SceneFolder folder;
  const Outcome outcome = run(folder, {"locate", "scene.csg", "--points", "points.csv", "--format", "csv"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out ==
        "point,location,part\n0,inside,left\n1,boundary,left\n2,inside,left\n3,inside,\"right "
        "\"\"R\"\"\"\n4,boundary,\n5,outside,\n");
}

TEST_CASE("locate as JSON and as text") {
  const SceneFolder folder;
  CHECK(run(folder, {"locate", "scene.csg", "--point", "1.5,0.5,0.5", "--format", "json"}).out ==
        "{\"points\": [\n{\"point\": 0, \"at\": [1.5, 0.5, 0.5], \"location\": \"inside\", \"part\": \"right "
        "\\\"R\\\"\"}\n]}\n");
  CHECK(run(folder, {"locate", "scene.csg", "--point", "9,9,0.1", "--format", "json"}).out ==
        "{\"points\": [\n{\"point\": 0, \"at\": [9, 9, 0.1], \"location\": \"outside\", \"part\": null}\n]}\n");
  CHECK(run(folder, {"locate", "scene.csg", "--point", "0.5,0.5,0"}).out ==
        "point 0 at 0.5,0.5,0: boundary, part left\n");
}

TEST_CASE("control characters in a part's name are escaped where people read it, and kept as CSV") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "part(\"a\\nb\x1b[2Jc\x7f\\td\\re\xc3\xa9\") { cube(1); }");
  const std::string shown = "a\\nb\\x1b[2Jc\\x7f\\td\\re\xc3\xa9";
  CHECK(run(folder, {"locate", "scene.csg", "--point", "0.5,0.5,0.5"}).out ==
        "point 0 at 0.5,0.5,0.5: inside, part " + shown + "\n");
  CHECK(run(folder, {"locate", "scene.csg", "--point", "0.5,0.5,0.5", "--format", "csv"}).out ==
        "point,location,part\n0,inside,\"a\nb\x1b[2Jc\x7f\td\re\xc3\xa9\"\n");
  const std::string table = run(folder, {"intervals", "scene.csg", "--ray", "0.5,0.5,9,0,0,-1"}).out;
  CHECK(table.find("  " + shown + "\n") != std::string::npos);
  const std::string info = run(folder, {"info", "scene.csg"}).out;
  CHECK(info.find("            " + shown + " at 1:1  density") != std::string::npos);
}

TEST_CASE("locate writes a file with -o and says nothing") {
  const SceneFolder folder;
  const Outcome outcome = run(folder, {"locate", "scene.csg", "--point", "9,9,9", "-o", "where.txt"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.empty());
  CHECK(folder.read("where.txt") == "point 0 at 9,9,9: outside\n");
}

TEST_CASE("one of --point and --points is needed") {
  const SceneFolder folder;
  const Outcome outcome = run(folder, {"locate", "scene.csg"});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.err == "csgcast: error: exactly one of --point and --points is needed; see csgcast locate --help\n");
}

}  // namespace
