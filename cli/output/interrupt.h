// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace csgcast::cli {

/// From now on Ctrl-C, a hang-up and a polite kill remove this unfinished file before they end the program. One file at
/// a time; the path may have up to 4095 bytes (a longer one is left alone).
void remove_if_interrupted(const std::string& path);

/// The file is finished, or gone: nothing is removed any more.
void keep_if_interrupted();

}  // namespace csgcast::cli
