// SPDX-License-Identifier: MIT
#include "cli/input/distinct_files.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <optional>
#include <vector>

#include "cli/output/printable.h"
#include "cli/output/usage.h"
#include "csg/base/number_text.h"
#include "csg/file/link_target.h"

namespace csgcast::cli {
namespace {

/// What makes a file the same as another: where it is on its device; or its path if it does not exist yet.
struct Identity {
  dev_t device = 0;
  ino_t inode = 0;
  std::string path;
  bool operator==(const Identity&) const = default;
};

/// None for what is no regular file.
std::optional<Identity> identity_of(const struct stat& status) {
  if (!S_ISREG(status.st_mode)) return std::nullopt;
  return Identity{status.st_dev, status.st_ino, {}};
}

std::optional<Identity> identity_of_input(const std::string& path) {
  struct stat status {};
  if (path.empty()) return std::nullopt;
  const int found = path == "-" ? ::fstat(STDIN_FILENO, &status) : ::stat(path.c_str(), &status);
  return found == 0 ? identity_of(status) : std::nullopt;
}

std::optional<Identity> identity_of_output(const std::string& path) {
  struct stat status {};
  if (path.empty()) return ::fstat(STDOUT_FILENO, &status) == 0 ? identity_of(status) : std::nullopt;
  if (::stat(path.c_str(), &status) == 0) return identity_of(status);
  return Identity{0, 0, link_target(path)};
}

std::string shown(const NamedFile& output) {
  return output.path.empty() ? "standard output" : fmt::format("{} {}", output.name, in_quotes(output.path));
}

}  // namespace

void check_distinct(std::span<const NamedFile> inputs, std::span<const NamedFile> outputs) {
  struct Taken {
    Identity identity;
    std::string what;
  };
  std::vector<Taken> taken;
  for (const NamedFile& input : inputs) {
    if (const auto identity = identity_of_input(input.path)) {
      taken.push_back({*identity, fmt::format("the file that {} is read from", input.name)});
    }
  }
  for (const NamedFile& output : outputs) {
    const auto identity = identity_of_output(output.path);
    if (!identity) continue;
    for (const Taken& other : taken) {
      if (other.identity == *identity) {
        throw UsageError(fmt::format("{} is {} (it would be overwritten)", shown(output), other.what));
      }
    }
    taken.push_back({*identity, fmt::format("the file that {} is written to", shown(output))});
  }
}

}  // namespace csgcast::cli
