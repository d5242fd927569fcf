// SPDX-License-Identifier: MIT
#include "tests/cli/hostile.h"

#include <algorithm>

#include "tests/support/catch.h"
#include "tests/support/effort.h"

namespace {

using namespace csgcast::test;

// Two seconds for the program as users have it; sanitizers make it some ten times slower.
constexpr double seconds_allowed = is_sanitized ? 30 : 2;

/// Without the line that says that a scene is empty, if it follows another.
std::string without_empty_scene(const std::string& said) {
  const std::size_t at = said.find("\nscene.csg: warning: the scene is empty");
  return at == std::string::npos ? said : said.substr(0, at + 1);
}

void check(const TemporaryFolder& folder, const Hostile& hostile, const std::vector<std::string>& arguments,
           const std::string& message) {
  const std::string old_output = "an older output";
  folder.write("out.png", old_output);
  const std::vector<std::string> names_before = folder.names();
  const Outcome outcome = run(folder, arguments, hostile.run);
  INFO("standard error: " << outcome.err.substr(0, 400));
  CHECK(outcome.exit_code == hostile.exit_code);
  CHECK(outcome.seconds < seconds_allowed);
  CHECK(outcome.err.substr(0, message.size()) == message);
  const std::string said = without_empty_scene(outcome.err);
  CHECK(std::count(said.begin(), said.end(), '\n') == (message.empty() ? 0 : 1));
  CHECK((folder.read("out.png") == old_output) == (hostile.exit_code != 0));
  CHECK(folder.names() == names_before);
}

void check_scenes(const std::vector<Hostile>& inputs) {
  for (const Hostile& hostile : inputs) {
    DYNAMIC_SECTION(hostile.name) {
      const TemporaryFolder folder;
      folder.write("scene.csg", hostile.text);
      const std::vector<std::string> render{"render", "scene.csg", "-o", "out.png", "--size", "16x16"};
      check(folder, hostile, hostile.arguments.empty() ? render : hostile.arguments,
            hostile.message.empty() ? "" : "scene.csg:" + hostile.message);
    }
  }
}

TEST_CASE("a hostile text ends within two seconds, with its place, and leaves the old output alone") {
  check_scenes(hostile_texts());
}

TEST_CASE("a hostile scene ends within two seconds, with its place, and leaves the old output alone") {
  check_scenes(hostile_scenes());
}

TEST_CASE("hostile rays and points end within two seconds, with their place, and leave the old output alone") {
  for (const Hostile& hostile : hostile_rows()) {
    DYNAMIC_SECTION(hostile.name) {
      const TemporaryFolder folder;
      folder.write("scene.csg", "cube(1);");
      folder.write("rows.csv", hostile.text);
      const std::vector<std::string> rays{"intervals", "scene.csg", "--rays", "rows.csv", "-o", "out.png"};
      check(folder, hostile, hostile.arguments.empty() ? rays : hostile.arguments,
            hostile.message.empty() ? "" : "rows.csv:" + hostile.message);
    }
  }
}

TEST_CASE("a hostile command line ends within two seconds, says why, and leaves the old output alone") {
  for (const Hostile& hostile : hostile_command_lines()) {
    DYNAMIC_SECTION(hostile.name) {
      const TemporaryFolder folder;
      folder.write("scene.csg", hostile.text);
      check(folder, hostile, hostile.arguments, hostile.message);
    }
  }
}

}  // namespace
