// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "csg/file/whole_file.h"

namespace csgcast::cli {

/// Where a command's result goes: standard output, or a WholeFile.
class Output {
 public:
  /// An empty path is standard output. Throws as WholeFile does.
  explicit Output(const std::string& path);

  /// Throws Error(machine) if the data cannot be written, BrokenPipe if nobody reads the output any more.
  void write(std::string_view data);
  void write(std::span<const std::byte> data);
  /// Ends the output and gives the file its name. Nothing may be written after it. Throws as write() does.
  void commit();

 private:
  void flush();
  void put(std::string_view data);

  std::optional<WholeFile> file_;  // none: standard output
  std::string buffer_;
};

/// The reader of the output has gone: no failure, but no reason to go on.
class BrokenPipe {};

}  // namespace csgcast::cli
