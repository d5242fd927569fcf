// SPDX-License-Identifier: MIT
#include "cli/command/commands.h"
#include "cli/output/usage.h"

#include <fmt/format.h>

#include "cli/input/command_line.h"
#include "cli/output/printable.h"

namespace csgcast::cli {

std::vector<Command> all_commands() {
  return {render_command(),  intervals_command(), locate_command(), measure_command(),
          section_command(), thickness_command(), check_command(),  info_command(),
          verify_command(),  join_command(),      help_command()};
}

const Command& command_named(const std::string& name, std::span<const Command> commands) {
  std::vector<std::string> known;
  for (const Command& command : commands) {
    if (command.name == name) return command;
    known.push_back(command.name);
  }
  throw UsageError(fmt::format("there is no command {}{}", in_quotes(name), suggestion(name, known)));
}

}  // namespace csgcast::cli
