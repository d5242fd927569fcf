// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace csgcast {

/// The file that writing to a path makes or changes: symbolic links are followed, also to a file that does not exist
/// yet, and the folders of the result are canonical. What cannot be followed (links in a circle, a pipe below /proc)
/// is returned as it is.
std::string link_target(const std::string& path);

}  // namespace csgcast
