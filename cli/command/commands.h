// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "cli/input/command.h"

namespace csgcast::cli {

/// One command each, with its options at their defaults.
Command render_command();
Command intervals_command();
Command locate_command();
Command measure_command();
Command section_command();
Command thickness_command();
Command check_command();
Command info_command();
Command verify_command();
Command join_command();
Command help_command();

/// All of them, in the order in which the help lists them.
std::vector<Command> all_commands();

/// The command of this name. Throws UsageError, with the nearest name, if there is none.
const Command& command_named(const std::string& name, std::span<const Command> commands);

}  // namespace csgcast::cli
