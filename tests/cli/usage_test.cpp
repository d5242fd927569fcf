// SPDX-License-Identifier: MIT
#include <algorithm>

#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_CASE("the option --help lists the commands, and each command's help shows an example") {
  const TemporaryFolder folder;
  const Outcome help = run(folder, {"--help"});
  CHECK(help.exit_code == 0);
  CHECK(help.err.empty());
  for (const char* name : {"render", "intervals", "locate", "info", "verify"}) {
    INFO(name);
    CHECK(contains(help.out, std::string("\n  ") + name + " "));
    const Outcome own = run(folder, {name, "--help"});
    CHECK(own.exit_code == 0);
    CHECK(contains(own.out, std::string("Example:\n  csgcast ") + name + " "));
    for (const char* option : {"--threads", "--facets", "--weld", "--quiet"}) CHECK(contains(own.out, option));
  }
}

TEST_CASE("the help says that the columns of rows have an order, and what the part column means") {
  const TemporaryFolder folder;
  const std::string intervals = run(folder, {"intervals", "--help"}).out;
  CHECK(contains(intervals, "in the order of --rays,"));
  CHECK(contains(intervals, "the part is that of the entry's face"));
  CHECK(contains(run(folder, {"locate", "--help"}).out, "in the order of --points,"));
}

TEST_CASE("the option --version names the program and its version") {
  const Outcome outcome = run(TemporaryFolder(), {"--version"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.substr(0, 8) == "csgcast ");
  CHECK(outcome.out.back() == '\n');
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), '.') == 2);
}

TEST_CASE("what the program does not know is one line that says so and names the help") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "cube(1);");
  const auto error = [&](const std::vector<std::string>& arguments) {
    const Outcome outcome = run(folder, arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    return outcome.err;
  };
  CHECK(error({}) == "csgcast: error: a command is missing; see csgcast --help\n");
  CHECK(error({"frobnicate", "scene.csg"}) == "csgcast: error: there is no command 'frobnicate'; see csgcast --help\n");
  CHECK(error({"info"}) == "csgcast: error: scene is required; see csgcast info --help\n");
  CHECK(error({"info", "scene.csg", "--shiny"}) ==
        "csgcast: error: the following argument was not expected: --shiny; see csgcast info --help\n");
  CHECK(error({"info", "scene.csg", "other.csg"}) ==
        "csgcast: error: the following argument was not expected: other.csg; see csgcast info --help\n");
  CHECK(error({"info", "scene.csg", "--format"}) ==
        "csgcast: error: --format needs a value; see csgcast info --help\n");
  CHECK(error({"info", "scene.csg", "--threads", "1", "--threads", "2"}) ==
        "csgcast: error: --threads is given more than once; see csgcast info --help\n");
  CHECK(error({"info", "scene.csg", "--threads", "many"}) ==
        "csgcast: error: --threads: 'many' is no whole number; see csgcast info --help\n");
  CHECK(error({"info", "scene.csg", "--facets", "some"}) ==
        "csgcast: error: --facets 'some' is unknown (known are auto|always|never); see csgcast info --help\n");
}

TEST_CASE("a scene may be called like a command, and start with a dash after --") {
  const TemporaryFolder folder;
  folder.write("render", "cube(1);");
  folder.write("-scene", "cube(1);");
  CHECK(run(folder, {"info", "render"}).exit_code == 0);
  CHECK(run(folder, {"info", "--", "-scene"}).exit_code == 0);
}

TEST_CASE("an error in a scene from standard input names it so") {
  RunOptions options;
  options.input = "cube(1);\ncubes(1);\n";
  const Outcome outcome = run(TemporaryFolder(), {"info", "-"}, options);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.err.substr(0, 31) == "<standard input>:2:1: error: th");
}

}  // namespace
