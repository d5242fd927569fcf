// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <span>

#include "cli/command/commands.h"
#include "cli/output/interrupt.h"
#include "cli/output/output.h"
#include "cli/output/usage.h"
#include "csg/base/error.h"

namespace {

using namespace csgcast;
using namespace csgcast::cli;

// What the program tells its caller. A path that cannot be written is bad input; a write that breaks off is the
// machine's failure.
constexpr int done = 0;
constexpr int machine_failed = 1;
constexpr int bad_input = 2;

/// What CLI11 says, in one line and in our words where its own are for programmers.
std::string in_our_words(const CLI::ParseError& error) {
  std::string text = error.what();
  text = text.substr(0, text.find('\n'));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    const std::string option = text.substr(0, text.find(':'));
    const bool repeated = text.find("At Most") != std::string::npos;
    return option + (repeated ? " is given more than once" : " needs a value");
  }
  // Its sentences begin with a capital, ours follow a colon.
  text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

int usage_error(const std::string& problem, const std::string& command) {
  fmt::print(stderr, "csgcast: error: {}; see csgcast {}--help\n", problem, command.empty() ? "" : command + ' ');
  return bad_input;
}

bool is_command(std::span<const Command> commands, const std::string& word) {
  return std::any_of(commands.begin(), commands.end(), [&](const Command& c) { return c.line->get_name() == word; });
}

int run(int argc, char** argv) {
  CLI::App program("csgcast looks at constructive solid geometry along rays: pictures, and exact answers about solids.",
                   "csgcast");
  program.set_version_flag("--version", "csgcast " CSGCAST_VERSION);
  program.require_subcommand(1);
  program.footer("csgcast COMMAND --help tells more, with examples.");
  const std::array commands{render_command(program),  intervals_command(program), locate_command(program),
                            measure_command(program), section_command(program),   thickness_command(program),
                            check_command(program),   info_command(program),      verify_command(program),
                            join_command(program)};
  const std::string first = argc > 1 ? argv[1] : "";
  const bool named = is_command(commands, first);
  try {
    if (first.empty()) return usage_error("a command is missing", "");
    if (!named && first[0] != '-') return usage_error(fmt::format("there is no command '{}'", first), "");
    program.parse(argc, argv);
    for (const Command& command : commands) {
      if (command.line->parsed()) command.run();
    }
    return done;
  } catch (const CLI::Success& success) {  // --help, --version
    return program.exit(success);
  } catch (const CLI::ParseError& error) {
    return usage_error(in_our_words(error), named ? first : "");
  } catch (const UsageError& error) {
    return usage_error(error.what(), first);
  }
}

}  // namespace

int main(int argc, char** argv) {
  // A reader that has gone and a file that may not grow come back as errors of write() instead.
  static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
  remove_files_if_interrupted();
  try {
    return run(argc, argv);
  } catch (const BrokenPipe&) {
    return done;
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return error.code() == ErrorCode::machine ? machine_failed : bad_input;
  } catch (const MachineError& error) {
    fmt::print(stderr, "{}\n", error.what());
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "csgcast: error: out of memory; try a smaller picture or scene\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "csgcast: error: something went wrong inside csgcast ({}); please report it\n", error.what());
  }
  return machine_failed;
}
