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
  CHECK(error({"redner", "scene.csg"}) ==
        "csgcast: error: there is no command 'redner' (did you mean 'render'?); see csgcast --help\n");
  CHECK(error({"info"}) == "csgcast: error: SCENE is missing; see csgcast info --help\n");
  CHECK(error({"section", "scene.csg"}) == "csgcast: error: --plane is missing; see csgcast section --help\n");
  CHECK(error({"info", "scene.csg", "--shiny"}) ==
        "csgcast: error: there is no option '--shiny'; see csgcast info --help\n");
  CHECK(error({"info", "scene.csg", "--thread=2"}) ==
        "csgcast: error: there is no option '--thread' (did you mean '--threads'?); see csgcast info --help\n");
  CHECK(error({"info", "scene.csg", "other.csg"}) ==
        "csgcast: error: 'other.csg' is one argument too many (the command is csgcast info [OPTIONS] SCENE); see "
        "csgcast info --help\n");
  CHECK(error({"intervals", "scene.csg", "--ray", "0,0,0,0,0,1", "--line", "--tmax", "2"}) ==
        "csgcast: error: --tmax cannot be given beside --line; see csgcast intervals --help\n");
  CHECK(error({"info", "scene.csg", "--format"}) ==
        "csgcast: error: --format needs a value; see csgcast info --help\n");
  CHECK(error({"info", "scene.csg", "--threads", "1", "--threads", "2"}) ==
        "csgcast: error: --threads is given more than once; see csgcast info --help\n");
  CHECK(error({"info", "scene.csg", "--threads", "many"}) ==
        "csgcast: error: --threads: 'many' is no whole number; see csgcast info --help\n");
  CHECK(error({"info", "scene.csg", "--facets", "some"}) ==
        "csgcast: error: --facets 'some' is unknown (known are auto|always|never); see csgcast info --help\n");
}

TEST_CASE("an option without effect is an error") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "cube(1);");
  const auto error = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin() + 1, "scene.csg");
    const Outcome outcome = run(folder, arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    return outcome.err;
  };
  for (const char* mode : {"depth", "normal", "id"}) {
    CHECK(contains(error({"render", "-o", "a.png", "--mode", mode, "--samples", "4"}), "--samples has no effect"));
  }
  CHECK(contains(error({"render", "--trace-pixel", "1,1", "--samples", "4"}), "--samples needs -o"));
  CHECK(contains(error({"render", "--trace-pixel", "1,1", "--stats", "s.json"}), "--stats needs -o"));
  CHECK(contains(error({"render", "-o", "a.png", "--adaptive"}), "--adaptive needs --samples"));
  CHECK(contains(error({"section", "--plane", "0,0,1,0.5", "--size", "9"}), "--size needs -o with a .png"));
  CHECK(contains(error({"section", "--plane", "0,0,1,0.5", "--size", "9", "-o", "a.svg"}), "--size needs -o"));
  CHECK(contains(error({"thickness", "--size", "9x9"}), "--size needs -o"));
  CHECK(contains(error({"thickness", "--camera", "9,9,9,0,0,0"}), "--camera needs -o"));
  CHECK(folder.names() == std::vector<std::string>{"scene.csg"});
}

TEST_CASE("standard output gets the same bytes by -o - as a file does") {
  const TemporaryFolder folder;
  folder.write("scene.csg", "cube(1);");
  const std::vector<std::vector<std::string>> commands = {{"render", "scene.csg", "--size", "16x12"},
                                                          {"intervals", "scene.csg", "--ray", "0.5,0.5,9,0,0,-1"},
                                                          {"locate", "scene.csg", "--point", "0.5,0.5,9"},
                                                          {"measure", "scene.csg"},
                                                          {"section", "scene.csg", "--plane", "0,0,1,0.5"},
                                                          {"thickness", "scene.csg", "--size", "16x12", "--grid", "8"},
                                                          {"check", "scene.csg"},
                                                          {"verify", "scene.csg", "--rays", "10"},
                                                          {"help", "render"}};
  for (std::vector<std::string> command : commands) {
    INFO(command.front());
    const bool is_picture = command.front() == "render" || command.front() == "thickness";
    const std::string file = is_picture ? "out.png" : command.front() == "section" ? "out.json" : "out.txt";
    command.insert(command.end(), {"-o", "-"});
    const Outcome printed = run(folder, command);
    CHECK(printed.exit_code == 0);
    CHECK(printed.err.empty() == (command.front() != "thickness"));
    command.back() = file;
    CHECK(run(folder, command).exit_code == 0);
    CHECK(printed.out == folder.read(file));
  }
  const Outcome twice = run(folder, {"render", "scene.csg", "-o", "-", "--stats", "-"});
  CHECK(twice.exit_code == 2);
  CHECK(contains(twice.err, "only one of -o, --stats and --trace-pixel can go to standard output"));
}

TEST_CASE("help explains each command as its option --help does, and names the default values") {
  const TemporaryFolder folder;
  const std::string all = run(folder, {"help"}).out;
  CHECK(all == run(folder, {"-h"}).out);
  for (const char* name :
       {"render", "intervals", "locate", "measure", "section", "thickness", "check", "info", "verify", "help"}) {
    INFO(name);
    CHECK(contains(all, std::string("\n  ") + name + " "));
    const Outcome help = run(folder, {"help", name});
    CHECK(help.exit_code == 0);
    CHECK(help.out == run(folder, {name, "--help"}).out);
  }
  CHECK(contains(run(folder, {"help", "render"}).out, "(default 800x600)"));
  CHECK(run(folder, {"-V"}).out == run(folder, {"--version"}).out);
  CHECK(run(folder, {"help", "rendr"}).exit_code == 2);
}

TEST_CASE("the manual page and the completion scripts hold each option of each command") {
  const TemporaryFolder folder;
  const std::string man = run(folder, {"help", "--man"}).out;
  CHECK(contains(man, ".TH CSGCAST 1"));
  for (const char* option : {"\\-\\-size", "\\-\\-plane", "\\-\\-grid", "\\-\\-seed", "\\-\\-relative\\-error"})
    CHECK(contains(man, option));
  for (const char* shell : {"bash", "zsh", "fish"}) {
    INFO(shell);
    const std::string script = run(folder, {"help", "--completion", shell}).out;
    for (const char* word : {"size", "plane", "grid", "seed", "relative-error", "thickness", "shaded"})
      CHECK(contains(script, word));
  }
  RunOptions in_bash;
  in_bash.program = "/bin/bash";
  const Outcome bash = run(folder,
                           {"-c",
                            "source <(\"$1\" help --completion bash); COMP_WORDS=(csgcast render --mode e); "
                            "COMP_CWORD=3; _csgcast; echo \"${COMPREPLY[@]}\"; COMP_WORDS=(csgcast thick); "
                            "COMP_CWORD=1; _csgcast; echo \"${COMPREPLY[@]}\"",
                            "bash", CSGCAST_PROGRAM},
                           in_bash);
  CHECK(bash.out == "edges\nthickness\n");
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
