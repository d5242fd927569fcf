// SPDX-License-Identifier: MIT
#pragma once

#include "cli/input/options.h"

namespace csgcast::cli {

/// Each adds its command to the program's line.
Command render_command(CLI::App& program);
Command intervals_command(CLI::App& program);
Command join_command(CLI::App& program);
Command locate_command(CLI::App& program);
Command thickness_command(CLI::App& program);
Command section_command(CLI::App& program);
Command check_command(CLI::App& program);
Command measure_command(CLI::App& program);
Command info_command(CLI::App& program);
Command verify_command(CLI::App& program);

}  // namespace csgcast::cli
