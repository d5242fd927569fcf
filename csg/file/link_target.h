// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace csgcast {

/// The file that a write to a path creates or changes. Symbolic links are followed, also to a file that does not exist
/// yet. The folders of the result are canonical. A path that cannot be followed (links in a circle, a pipe below /proc)
/// is returned unchanged.
std::string link_target(const std::string& path);

}  // namespace csgcast
