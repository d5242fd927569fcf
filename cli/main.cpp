// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "cli/command/commands.h"
#include "cli/input/command_line.h"
#include "cli/manual/help_text.h"
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

int usage_error(const std::string& problem, const std::string& command) {
  fmt::print(stderr, "csgcast: error: {}; see csgcast {}--help\n", problem, command.empty() ? "" : command + ' ');
  return bad_input;
}

int print(const std::string& text) {
  Output output("");
  output.write(text);
  output.commit();
  return done;
}

int run(std::span<const std::string> arguments) {
  if (arguments.empty()) return usage_error("a command is missing", "");
  const std::string& first = arguments.front();
  if (first == "-V" || first == "--version") return print("csgcast " CSGCAST_VERSION "\n");
  const std::vector<Command> commands = all_commands();
  if (first == "-h" || first == "--help") return print(help_text(commands));
  std::string name;
  try {
    const Command& command = command_named(first, commands);
    name = first;
    if (!read_command_line(command, arguments.subspan(1))) return print(help_text(command));
    command.run();
    return done;
  } catch (const UsageError& error) {
    return usage_error(error.what(), name);
  }
}

}  // namespace

int main(int argc, char** argv) {
  // A reader that has gone and a file that may not grow come back as errors of write() instead.
  static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
  remove_files_if_interrupted();
  try {
    const std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    return run(arguments);
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
