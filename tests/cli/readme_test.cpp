// SPDX-License-Identifier: MIT
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;

const std::string indent = "    ";
const std::string prompt = indent + "$ csgcast ";

/// One command as README.md shows it.
struct Shown {
  std::vector<std::string> arguments;
  std::string output;
};

/// The indented blocks that begin with `$ csgcast`; the output is the rest of the block.
std::vector<Shown> shown_commands() {
  std::ifstream readme(CSGCAST_SOURCE_DIR "/README.md");
  std::vector<Shown> commands;
  bool within = false;
  for (std::string line; std::getline(readme, line);) {
    if (line.starts_with(prompt)) {
      std::istringstream words(line.substr(prompt.size()));
      commands.push_back({{std::istream_iterator<std::string>(words), {}}, {}});
      within = true;
    } else if (within && line.starts_with(indent)) {
      commands.back().output += line.substr(indent.size()) + '\n';
    } else {
      within = false;
    }
  }
  return commands;
}

/// The text with every time that was measured as one word.
std::string without_seconds(const std::string& text) {
  return std::regex_replace(text, std::regex("(read|compile) [0-9.]+"), "$1 TIME");
}

TEST_CASE("the commands that README shows print what it says") {
  const TemporaryFolder folder;
  std::filesystem::create_directory_symlink(CSGCAST_SOURCE_DIR "/examples", folder.path("examples"));
  const std::vector<Shown> commands = shown_commands();
  CHECK(commands.size() >= 2);
  for (const Shown& shown : commands) {
    const Outcome outcome = run(folder, shown.arguments);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    CHECK(without_seconds(outcome.out) == without_seconds(shown.output));
  }
}

}  // namespace
