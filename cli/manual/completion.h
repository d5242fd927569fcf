// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "cli/input/command.h"

namespace csgcast::cli {

enum class Shell : std::uint8_t { bash, zsh, fish };

/// The script that teaches a shell to complete commands, options, their words and files.
std::string completion(Shell shell, std::span<const Command> commands);

}  // namespace csgcast::cli
