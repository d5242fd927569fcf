// SPDX-License-Identifier: MIT
#include <csignal>

#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;

const std::vector<std::string> names_of_scene{"scene.csg"};

struct SceneFolder : TemporaryFolder {
  SceneFolder() { write("scene.csg", "cube(1);"); }
};

std::vector<std::string> ray_into(const std::string& path) {
  return {"intervals", "scene.csg", "--ray", "0.5,0.5,9,0,0,-1", "--format", "csv", "-o", path};
}

TEST_CASE("an output replaces an older file, keeps its permissions and leaves nothing else behind") {
  const SceneFolder folder;
  folder.write("out.csv", "old");
  const auto private_file = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
  std::filesystem::permissions(folder.path("out.csv"), private_file);
  CHECK(run(folder, ray_into("out.csv")).exit_code == 0);
  CHECK(folder.read("out.csv").substr(0, 4) == "ray,");
  CHECK(std::filesystem::status(folder.path("out.csv")).permissions() == private_file);
  CHECK(folder.names() == std::vector<std::string>{"out.csv", "scene.csg"});
}

TEST_CASE("an output goes through a link to the file that it names") {
  const SceneFolder folder;
  folder.write("real.csv", "old");
  std::filesystem::create_symlink("real.csv", folder.path("link.csv"));
  CHECK(run(folder, ray_into("link.csv")).exit_code == 0);
  CHECK(std::filesystem::is_symlink(folder.path("link.csv")));
  CHECK(folder.read("real.csv").substr(0, 4) == "ray,");
}

TEST_CASE("an output goes through links to a file that does not exist yet") {
  const SceneFolder folder;
  std::filesystem::create_directory(folder.path("results"));
  std::filesystem::create_symlink("results/next", folder.path("link.csv"));
  std::filesystem::create_symlink("new.csv", folder.path("results/next"));
  CHECK(run(folder, ray_into("link.csv")).exit_code == 0);
  CHECK(std::filesystem::is_symlink(folder.path("link.csv")));
  CHECK(std::filesystem::is_symlink(folder.path("results/next")));
  CHECK(folder.read("results/new.csv").substr(0, 4) == "ray,");
}

TEST_CASE("a picture goes through a link to a file that does not exist yet") {
  const SceneFolder folder;
  std::filesystem::create_symlink("new.png", folder.path("link.png"));
  CHECK(run(folder, {"render", "scene.csg", "-o", "link.png", "--size", "8x6"}).exit_code == 0);
  CHECK(std::filesystem::is_symlink(folder.path("link.png")));
  CHECK(folder.read("new.png").substr(1, 3) == "PNG");
}

TEST_CASE("a link that leads nowhere but to itself cannot be written to") {
  const SceneFolder folder;
  std::filesystem::create_symlink("link.csv", folder.path("link.csv"));
  const Outcome outcome = run(folder, ray_into("link.csv"));
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.err.find("link.csv: error: cannot write this file (Too many levels of symbolic links)") == 0);
  CHECK(std::filesystem::is_symlink(std::filesystem::symlink_status(folder.path("link.csv"))));
}

TEST_CASE("a device is written to and stays a device") {
  const SceneFolder folder;
  CHECK(run(folder, ray_into("/dev/null")).exit_code == 0);
  CHECK(std::filesystem::is_character_file("/dev/null"));
}

TEST_CASE("a program that is asked to stop takes its unfinished file along") {
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    const SceneFolder folder;
    RunOptions options;
    options.signal_while_writing = signal_number;
    const Outcome outcome = run(folder, {"intervals", "scene.csg", "--rays", "-", "-o", "out.csv"}, options);
    CHECK(outcome.exit_code == 128 + signal_number);
    CHECK(folder.names() == names_of_scene);
  }
}

TEST_CASE("an error after many answers leaves no half of a file") {
  const SceneFolder folder;
  std::string rays;
  for (int i = 0; i < 5000; ++i) rays += "0.5,0.5,9,0,0,-1\n";
  folder.write("rays.csv", rays + "0.5,0.5,9,0,oops,-1\n");
  folder.write("out.csv", "old");
  const Outcome outcome = run(folder, {"intervals", "scene.csg", "--rays", "rays.csv", "-o", "out.csv"});
  CHECK(outcome.exit_code == 2);
  CHECK(
      outcome.err ==
      "rays.csv:5001:13: error: 'oops' is no number (only numbers stand here); write ox,oy,oz,dx,dy,dz on each line\n");
  CHECK(folder.read("out.csv") == "old");
  CHECK(folder.names() == std::vector<std::string>{"out.csv", "rays.csv", "scene.csg"});
}

TEST_CASE("a reader that goes away is no error") {
  const SceneFolder folder;
  std::string rays;
  for (int i = 0; i < 50000; ++i) rays += "0.5,0.5,9,0,0,-1\n";
  folder.write("rays.csv", rays);
  RunOptions options;
  options.reader_goes_away = true;
  const Outcome outcome = run(folder, {"intervals", "scene.csg", "--rays", "rays.csv", "--format", "csv"}, options);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
}

TEST_CASE("a full standard output is the machine's failure") {
  const SceneFolder folder;
  RunOptions options;
  options.standard_output = "/dev/full";
  const Outcome outcome = run(folder, {"info", "scene.csg"}, options);
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.err ==
        "csgcast: error: cannot write standard output (No space left on device); make room or choose another place\n");
}

}  // namespace
