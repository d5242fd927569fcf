// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace csgcast::cli {

/// Where a command's result goes: standard output, or a file that appears whole or not at all.
///
/// A file is written beside its target under another name, which commit() changes to the target's; if it never comes to
/// that, the target stays as it was and nothing is left behind, even after Ctrl-C. A link is followed, also to a file
/// that does not exist yet; an existing file's permissions are kept. What is no regular file (a device, a pipe) is
/// written to directly.
class Output {
 public:
  /// An empty path is standard output. Throws Error(input_output) if the path cannot be written (no such folder, no
  /// permission, a folder), MachineError if the disk is full.
  explicit Output(const std::string& path);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Throws MachineError if the data cannot be written, BrokenPipe if nobody reads standard output any more.
  void write(std::string_view data);
  /// Ends the output and gives the file its name. Nothing may be written after it. Throws MachineError.
  void commit();

 private:
  void open_target();
  void flush();
  [[noreturn]] void fail(int error) const;

  std::string path_;       // as messages name it; empty for standard output
  std::string target_;     // with links followed
  std::string temporary_;  // empty if written to directly
  int file_ = -1;
  std::string buffer_;
};

/// The reader of standard output has gone: no failure, but no reason to go on.
class BrokenPipe {};

/// Throws as Output(path) does, and leaves the path as it is.
void check_writable(const std::string& path);

}  // namespace csgcast::cli
