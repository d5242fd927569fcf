// SPDX-License-Identifier: MIT
#include <algorithm>
#include <csignal>
#include <string>
#include <vector>

#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;
using std::filesystem::perms;

struct SceneFolder : TemporaryFolder {
  SceneFolder() { write("scene.csg", "part(\"block\") { cube(1); }"); }
};

/// The arguments of a run that writes a file, which is the last of them.
using Arguments = std::vector<std::string>;

/// Every command with an output, and every way of each to write one.
std::vector<Arguments> writers() {
  return {{"render", "scene.csg", "--size", "8x6", "-o", "out.png"},
          {"render", "scene.csg", "--size", "8x6", "-o", "out.jpg"},
          {"render", "scene.csg", "--size", "8x6", "-o", "out.tif"},
          {"render", "scene.csg", "--size", "8x6", "-o", "out.exr"},
          {"render", "scene.csg", "--size", "8x6", "-o", "other.png", "--stats", "out.json"},
          {"intervals", "scene.csg", "--ray", "0.5,0.5,9,0,0,-1", "-o", "out.csv"},
          {"locate", "scene.csg", "--point", "0,0,0", "-o", "out.txt"},
          {"measure", "scene.csg", "-o", "out.txt"},
          {"section", "scene.csg", "--plane", "0,0,1,0.5", "-o", "out.svg"},
          {"section", "scene.csg", "--plane", "0,0,1,0.5", "-o", "out.json"},
          {"section", "scene.csg", "--plane", "0,0,1,0.5", "--size", "8", "-o", "out.png"},
          {"thickness", "scene.csg", "--grid", "4", "--size", "8x6", "-o", "out.png"},
          {"check", "scene.csg", "-o", "out.txt"},
          {"info", "scene.csg", "-o", "out.txt"},
          {"verify", "scene.csg", "--rays", "10", "-o", "out.txt"}};
}

}  // namespace

TEST_CASE("every command keeps the permissions of the file that it replaces, and those of new files are as usual") {
  for (const Arguments& arguments : writers()) {
    const SceneFolder folder;
    const std::string& output = arguments.back();
    INFO(arguments[0] << " to " << output);
    const auto mode = [&] { return std::filesystem::status(folder.path(output)).permissions(); };
    REQUIRE(run(folder, arguments).exit_code == 0);
    const std::string content = folder.read(output);
    CHECK_FALSE(content.empty());
    CHECK(mode() == std::filesystem::status(folder.path("scene.csg")).permissions());
    for (const int permissions : {0600, 0640, 0755}) {
      folder.write(output, "old");
      std::filesystem::permissions(folder.path(output), static_cast<perms>(permissions));
      REQUIRE(run(folder, arguments).exit_code == 0);
      CHECK(mode() == static_cast<perms>(permissions));
      CHECK(folder.read(output) != "old");
    }
    for (const std::string& name : folder.names()) CHECK(name[0] != '.');
  }
}

TEST_CASE("every command follows links to the file that it writes") {
  for (const Arguments& arguments : writers()) {
    const SceneFolder folder;
    INFO(arguments[0] << " to " << arguments.back());
    std::filesystem::create_directory(folder.path("there"));
    std::filesystem::create_symlink("there/new", folder.path(arguments.back()));
    CHECK(run(folder, arguments).exit_code == 0);
    CHECK(std::filesystem::is_symlink(folder.path(arguments.back())));
    CHECK_FALSE(folder.read("there/new").empty());
  }
}

TEST_CASE("a picture that is interrupted leaves the older file and nothing else") {
  const SceneFolder folder;
  folder.write("out.png", "old");
  folder.write("out.json", "old");
  const std::vector<std::string> names{"out.json", "out.png", "scene.csg"};
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    RunOptions options;
    options.signal_while_writing = signal_number;
    const Outcome outcome = run(folder,
                                {"render", "scene.csg", "-o", "out.png", "--stats", "out.json", "--size", "8000x8000",
                                 "--samples", "64", "--threads", "1"},
                                options);
    CHECK(outcome.exit_code == 128 + signal_number);
    CHECK(folder.names() == names);
    CHECK(folder.read("out.png") == "old");
  }
}

TEST_CASE("many rows that are interrupted leave the older file and nothing else") {
  const SceneFolder folder;
  std::string rays;
  for (int i = 0; i < 2'000'000; ++i) rays += "0.5,0.5,9,0,0,-1\n";
  folder.write("rays.csv", rays);
  folder.write("out.csv", "old");
  RunOptions options;
  options.signal_while_writing = SIGINT;
  const Outcome outcome =
      run(folder, {"intervals", "scene.csg", "--rays", "rays.csv", "-o", "out.csv", "--threads", "1"}, options);
  CHECK(outcome.exit_code == 128 + SIGINT);
  CHECK(folder.names() == std::vector<std::string>{"out.csv", "rays.csv", "scene.csg"});
  CHECK(folder.read("out.csv") == "old");
}

TEST_CASE("a picture is written to a device directly") {
  const SceneFolder folder;
  std::filesystem::create_symlink("/dev/null", folder.path("null.png"));
  CHECK(run(folder, {"render", "scene.csg", "-o", "null.png", "--size", "8x6"}).exit_code == 0);
  CHECK(std::filesystem::is_symlink(folder.path("null.png")));
  CHECK(std::filesystem::is_character_file("/dev/null"));
}
