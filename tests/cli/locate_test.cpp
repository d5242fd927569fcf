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
