// SPDX-License-Identifier: MIT
#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;

const std::string scene = "cube(1);";
const std::string rays = "0.5,0.5,9,0,0,-1\n";

struct SceneFolder : TemporaryFolder {
  SceneFolder() {
    write("box.csg", scene);
    write("rays.csv", rays);
  }
};

/// The message, after a check that the program refused and left both inputs as they were.
std::string refusal(const SceneFolder& folder, const std::vector<std::string>& arguments,
                    const RunOptions& options = {}) {
  const Outcome outcome = run(folder, arguments, options);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.empty());
  CHECK(folder.read("box.csg") == scene);
  CHECK(folder.read("rays.csv") == rays);
  return outcome.err;
}

std::string message(const std::string& problem, const std::string& command) {
  return "csgcast: error: " + problem + " (it would be overwritten); see csgcast " + command + " --help\n";
}

TEST_CASE("no command overwrites the scene that it reads") {
  const SceneFolder folder;
  const std::string problem = "-o 'box.csg' is the file that the scene is read from";
  CHECK(refusal(folder, {"intervals", "box.csg", "--ray", "0,0,9,0,0,-1", "-o", "box.csg"}) ==
        message(problem, "intervals"));
  CHECK(refusal(folder, {"locate", "box.csg", "--point", "0,0,9", "-o", "box.csg"}) == message(problem, "locate"));
  CHECK(refusal(folder, {"info", "box.csg", "-o", "box.csg"}) == message(problem, "info"));
  CHECK(refusal(folder, {"render", "box.csg", "-o", "a.png", "--stats", "box.csg"}) ==
        message("--stats 'box.csg' is the file that the scene is read from", "render"));
  CHECK(folder.names() == std::vector<std::string>{"box.csg", "rays.csv"});
}

TEST_CASE("no command overwrites the rows that it reads") {
  const SceneFolder folder;
  CHECK(refusal(folder, {"intervals", "box.csg", "--rays", "rays.csv", "-o", "rays.csv"}) ==
        message("-o 'rays.csv' is the file that --rays is read from", "intervals"));
  CHECK(refusal(folder, {"locate", "box.csg", "--points", "rays.csv", "-o", "rays.csv"}) ==
        message("-o 'rays.csv' is the file that --points is read from", "locate"));
}

TEST_CASE("an input is known by any name: another spelling, a link, a hard link") {
  const SceneFolder folder;
  std::filesystem::create_symlink("box.csg", folder.path("link.csg"));
  std::filesystem::create_hard_link(folder.path("box.csg"), folder.path("hard.csg"));
  for (const std::string name : {"./box.csg", "link.csg", "hard.csg"}) {
    CHECK(refusal(folder, {"info", "box.csg", "-o", name}) ==
          message("-o '" + name + "' is the file that the scene is read from", "info"));
  }
  CHECK(refusal(folder, {"info", "link.csg", "-o", "box.csg"}) ==
        message("-o 'box.csg' is the file that the scene is read from", "info"));
}

TEST_CASE("standard output may not be the file that is read") {
  const SceneFolder folder;
  RunOptions options;
  options.standard_output = folder.path("box.csg").string();
  CHECK(refusal(folder, {"info", "box.csg"}, options) ==
        message("standard output is the file that the scene is read from", "info"));
}

TEST_CASE("two outputs may not be one file, whether it exists or not") {
  const SceneFolder folder;
  const std::string problem = "--stats './s.png' is the file that -o 's.png' is written to";
  const std::vector<std::string> arguments{"render", "box.csg", "-o", "s.png", "--stats", "./s.png"};
  CHECK(refusal(folder, arguments) == message(problem, "render"));
  folder.write("s.png", "old");
  CHECK(refusal(folder, arguments) == message(problem, "render"));
  CHECK(folder.read("s.png") == "old");
}

TEST_CASE("two links to one file that does not exist yet are one output") {
  const SceneFolder folder;
  std::filesystem::create_symlink("new.png", folder.path("a.png"));
  std::filesystem::create_symlink(folder.path("new.png"), folder.path("b.json"));
  CHECK(refusal(folder, {"render", "box.csg", "-o", "a.png", "--stats", "b.json"}) ==
        message("--stats 'b.json' is the file that -o 'a.png' is written to", "render"));
}

TEST_CASE("a device may be named twice, and a missing input is not mistaken for an output") {
  const SceneFolder folder;
  CHECK(run(folder, {"info", "/dev/null", "--quiet", "-o", "/dev/null"}).exit_code == 0);
  const Outcome missing = run(folder, {"info", "new.csg", "-o", "new.csg"});
  CHECK(missing.exit_code == 2);
  CHECK(missing.err.find("new.csg: error: ") == 0);
}

}  // namespace
