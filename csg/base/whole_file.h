// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace csgcast {

/// Writes a file that appears whole or not at all: beside its target (where symbolic links lead, even if nothing is
/// there yet), then renamed. On failure throws Error(input_output), removes what was written and leaves an existing
/// file as it was.
void write_whole_file(const std::string& path, std::span<const std::byte> bytes);

}  // namespace csgcast
