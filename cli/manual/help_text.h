// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "cli/input/command.h"

namespace csgcast::cli {

/// What `csgcast --help` prints: what the program is, and its commands.
std::string help_text(std::span<const Command> commands);

/// What `csgcast COMMAND --help` prints, in lines of at most 80 columns.
std::string help_text(const Command& command);

/// An option's help with its default: `Width and height in pixels (default 800x600)`.
std::string explained(const Option& option);

/// What the program is, in one sentence.
std::string_view program_summary();

}  // namespace csgcast::cli
