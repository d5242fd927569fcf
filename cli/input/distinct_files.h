// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace csgcast::cli {

/// A file that a command reads or writes.
struct NamedFile {
  std::string name;  ///< what messages call it: an option, or "the scene"
  std::string path;  ///< of an input "-" is standard input; an empty one is no input, but standard output
};

/// Throws UsageError if an output is the same file as an input or as another output, under whatever name: another
/// spelling of the path, a link, a hard link, a redirection. Devices and pipes may be named as often as one likes.
void check_distinct(std::span<const NamedFile> inputs, std::span<const NamedFile> outputs);

}  // namespace csgcast::cli
