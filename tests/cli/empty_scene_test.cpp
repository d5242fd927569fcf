// SPDX-License-Identifier: MIT
#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;

const std::string warning = "scene.csg: warning: the scene is empty (no solid is left in it); rays meet nothing\n";

TEST_CASE("an empty scene is no error, but each command says so once") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "light(position = [0, 0, 9]);\nunion();");
  const auto check = [&](const std::vector<std::string>& arguments) {
    const Outcome outcome = run(folder, arguments);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err == warning);
    return outcome.out;
  };
  CHECK(check({"render", "scene.csg", "-o", "a.png", "--size", "8x6"}).empty());
  CHECK(check({"intervals", "scene.csg", "--ray", "0,0,9,0,0,-1"}) == "ray 0 from 0,0,9 along 0,0,-1: nothing\n");
  CHECK(check({"locate", "scene.csg", "--point", "0,0,0"}) == "point 0 at 0,0,0: outside\n");
  const std::string info = check({"info", "scene.csg"});
  CHECK(info.find("\nbounds      empty\n") != std::string::npos);
  CHECK(info.find("\nwarnings    1\n") != std::string::npos);
  CHECK(run(folder, {"info", "scene.csg", "--quiet"}).err.empty());
}

}  // namespace
