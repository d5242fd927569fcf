// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace csgcast::test {

/// A new folder that goes away with it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, std::string_view content) const;
  std::string read(const std::string& name) const;
  /// The names of everything in it, hidden files included, sorted.
  std::vector<std::string> names() const;
  const std::filesystem::path& root() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// How a run of the program ended.
struct Outcome {
  int exit_code = -1;  ///< 128 + the signal's number if a signal ended it
  std::string out;
  std::string err;
  double seconds =
      0;  ///< of the clock or of the processors, whichever is less: on a busy machine the clock says little
};

struct RunOptions {
  std::string input;                          ///< standard input
  std::string program{};                      ///< the program to run; empty: csgcast
  std::optional<std::uint64_t> largest_file;  ///< bytes; a write beyond fails as on a full disk
  bool reader_goes_away = false;              ///< standard output is closed after its first bytes
  std::string standard_output;                ///< a file to be standard output instead of `out`
  /// Standard input stays open, and this signal is sent once the program has begun to write a file in the folder.
  std::optional<int> signal_while_writing;
};

/// Runs csgcast in a folder, with these arguments. After a minute it is killed.
Outcome run(const TemporaryFolder& folder, const std::vector<std::string>& arguments, const RunOptions& options = {});

}  // namespace csgcast::test
