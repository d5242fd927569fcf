// SPDX-License-Identifier: MIT
#include "csg/base/whole_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <random>
#include <system_error>

#include "csg/base/error.h"
#include "csg/base/link_target.h"

namespace csgcast {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& why) {
  throw Error(ErrorCode::input_output, {path, 0, 0}, "the file cannot be written", why,
              "check that the folder exists and may be written to, and that the disk has room");
}

std::string text_of(int error) { return std::generic_category().message(error); }

// Removes its file unless it was renamed.
class Temporary {
 public:
  explicit Temporary(const fs::path& target) {
    std::random_device random;
    path_ = target;
    path_.replace_filename(fmt::format(".{:.200}.{}.tmp", target.filename().string(), random()));
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    std::error_code ignored;
    if (!renamed_) fs::remove(path_, ignored);
  }

  const fs::path& path() const { return path_; }

  void rename_to(const fs::path& target) {
    std::error_code error;
    fs::rename(path_, target, error);
    if (error) fail(target.string(), error.message());
    renamed_ = true;
  }

 private:
  fs::path path_;
  bool renamed_ = false;
};

void write_bytes(const fs::path& path, const std::string& target, std::span<const std::byte> bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wbx");
  if (file == nullptr) fail(target, text_of(errno));
  int error = 0;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size() || std::fflush(file) != 0) error = errno;
  if (std::fclose(file) != 0 && error == 0) error = errno;
  if (error != 0) fail(target, text_of(error));
}

}  // namespace

void write_whole_file(const std::string& path, std::span<const std::byte> bytes) {
  std::error_code error;
  const fs::path resolved = link_target(path);
  if (fs::is_symlink(resolved, error)) fail(path, "its links cannot be followed");
  if (fs::exists(resolved, error) && !fs::is_regular_file(resolved, error)) fail(path, "it is not a regular file");
  Temporary temporary(resolved);
  write_bytes(temporary.path(), path, bytes);
  temporary.rename_to(resolved);
}

}  // namespace csgcast
