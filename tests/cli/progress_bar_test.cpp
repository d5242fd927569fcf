// SPDX-License-Identifier: MIT
#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;

/// What a command prints on a terminal until it is interrupted, as by Ctrl-C, after two seconds.
std::string interrupted_on_terminal(const TemporaryFolder& folder, const std::string& arguments) {
  RunOptions options;
  options.program = "/bin/bash";
  return run(folder,
             {"-c", "script -qec \"timeout -s INT 2 '$1' " + arguments + "\" /dev/null", "bash", CSGCAST_PROGRAM},
             options)
      .out;
}

TEST_CASE("a long command on a terminal shows how much is done and the time left, and Ctrl-C erases that") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "sphere(r = 1);");
  const std::string text = interrupted_on_terminal(folder, "verify scene.csg --rays 500000000");
  CHECK(text.find("verifying [") != std::string::npos);
  CHECK(text.find(" left\033[K") != std::string::npos);
  CHECK(text.ends_with("\r\033[K"));
  CHECK(interrupted_on_terminal(folder, "verify scene.csg -q --rays 500000000").empty());
}

}  // namespace
