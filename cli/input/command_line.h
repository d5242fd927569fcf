// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "cli/input/command.h"

namespace csgcast::cli {

/// Gives the arguments of a command, without its name, to the options and operands that take them. Returns false if the
/// help is asked for (-h, --help); nothing is taken then. Throws UsageError.
bool read_command_line(const Command& command, std::span<const std::string> arguments);

/// ` (did you mean '--size'?)` for the known word that is nearest to a misspelt one; nothing if none is near.
std::string suggestion(const std::string& word, std::span<const std::string> known);

}  // namespace csgcast::cli
