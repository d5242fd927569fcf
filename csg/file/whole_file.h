// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace csgcast {

/// A file that is being written. It appears whole or not at all.
///
/// It is written beside its target under another name, `.csgcast-..`. commit() changes that name to the target's. Until
/// then, and if commit() is never called, an older file stays as it was. Nothing else is left behind, not after an
/// exception, and not after a signal whose handler calls remove_unfinished_files(). An older file's permissions are
/// kept. Links are followed, also to a file that does not exist yet. A target that is not a regular file (a device, a
/// pipe) is written to directly.
///
/// For one thread at a time.
class WholeFile {
 public:
  /// Throws Error(input_output) if the path cannot be written (no such folder, no permission, a folder), Error(machine)
  /// if the disk is full.
  explicit WholeFile(const std::string& path);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// The path as it was given.
  const std::string& path() const { return path_; }

  /// Throws Error(machine) if the data cannot be written.
  void write(std::string_view data);
  void write(std::span<const std::byte> data);
  /// Finishes the file and gives it its name. Nothing may be written after it. Throws Error(machine).
  void commit();

  /// True if the last write failed because the path is a pipe that nobody reads any more.
  bool has_lost_reader() const { return has_lost_reader_; }

 private:
  struct Unfinished;

  void open_beside(std::optional<unsigned> permissions);
  [[noreturn]] void fail(int error);
  friend void remove_unfinished_files() noexcept;

  std::string path_;
  std::string target_;                // with links followed
  Unfinished* unfinished_ = nullptr;  // the file beside the target; null if the target is written to directly
  int file_ = -1;
  bool has_lost_reader_ = false;
};

/// Removes the files that any WholeFile of the process has written and not committed. It is safe in the signal handler
/// of a program that is about to end. The library itself handles no signals.
void remove_unfinished_files() noexcept;

}  // namespace csgcast
