// SPDX-License-Identifier: MIT
#include "csg/file/link_target.h"

#include <filesystem>
#include <system_error>

namespace csgcast {
namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;  // as many as Linux follows

/// The end of a chain of links. The last link may point to a file that does not exist. Empty if the chain does not end.
fs::path end_of_links(fs::path place) {
  std::error_code error;
  for (int i = 0; i <= most_links; ++i) {
    if (!fs::is_symlink(place, error)) return place;
    place = place.parent_path() / fs::read_symlink(place, error);  // an absolute target replaces the folder
    if (error) return {};
  }
  return {};
}

}  // namespace

std::string link_target(const std::string& path) {
  std::error_code error;
  if (fs::exists(path, error)) {
    const fs::path target = fs::canonical(path, error);
    return error ? path : target.string();
  }
  const fs::path place = fs::absolute(end_of_links(path), error);
  if (error) return path;
  const fs::path folder = fs::weakly_canonical(place.parent_path(), error);
  return error ? path : (folder / place.filename()).string();
}

}  // namespace csgcast
