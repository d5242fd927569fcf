// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "cli/input/command.h"

namespace csgcast::cli {

/// The manual page csgcast(1) as troff, for man: all commands with their options.
std::string man_page(std::span<const Command> commands);

}  // namespace csgcast::cli
