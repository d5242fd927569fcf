// SPDX-License-Identifier: MIT
#include "cli/output/output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "cli/output/interrupt.h"
#include "cli/output/usage.h"
#include "csg/base/error.h"
#include "csg/base/link_target.h"

namespace csgcast::cli {
namespace {

constexpr std::size_t buffer_size = 1 << 16;

/// Whether it is the machine that is at its end, rather than a path that makes no sense.
bool is_machine_failure(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
    case EIO:
    case ENOMEM:
    case EMFILE:
    case ENFILE:
      return true;
    default:
      return false;
  }
}

std::string cannot_write(const std::string& path, int error) {
  return fmt::format("{}: error: cannot write {} ({}); make room or choose another place",
                     path.empty() ? "csgcast" : path, path.empty() ? "standard output" : "this file",
                     std::strerror(error));
}

[[noreturn]] void cannot_open(const std::string& path, int error) {
  if (is_machine_failure(error)) throw MachineError(cannot_write(path, error));
  throw Error(ErrorCode::input_output, {path, 0, 0}, "cannot write this file", std::strerror(error),
              "choose a path in a folder that exists and may be written");
}

/// A new file in the target's folder with the target's permissions; its name goes to `name`. -1 and errno if there can
/// be none.
int open_beside(const std::string& target, std::string& name) {
  struct stat existing {};
  const bool replaces = ::stat(target.c_str(), &existing) == 0;
  const std::string folder = std::filesystem::path(target).parent_path().string();
  for (int attempt = 0; attempt < 1000; ++attempt) {
    name = fmt::format("{}/.csgcast-{}-{}", folder.empty() ? "." : folder, ::getpid(), attempt);
    const int file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0 && errno == EEXIST) continue;
    // Keeping the permissions is a courtesy: a file system that has none is no reason to stop.
    if (file >= 0 && replaces) static_cast<void>(::fchmod(file, existing.st_mode & 0777));
    return file;
  }
  return -1;
}

}  // namespace

Output::Output(const std::string& path) : path_(path) {
  if (path.empty()) {
    file_ = STDOUT_FILENO;
  } else {
    open_target();
  }
}

void Output::open_target() {
  target_ = link_target(path_);
  struct stat existing {};
  const bool exists = ::stat(target_.c_str(), &existing) == 0;
  if (!exists && errno == ELOOP) cannot_open(path_, ELOOP);
  if (exists && S_ISDIR(existing.st_mode)) cannot_open(path_, EISDIR);
  if (exists && !S_ISREG(existing.st_mode)) {
    file_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  } else if (exists && ::access(target_.c_str(), W_OK) != 0) {
    cannot_open(path_, errno);
  } else {
    file_ = open_beside(target_, temporary_);
  }
  if (file_ < 0) cannot_open(path_, errno);
  if (!temporary_.empty()) remove_if_interrupted(temporary_);
}

Output::~Output() {
  if (!path_.empty() && file_ >= 0) ::close(file_);
  if (!temporary_.empty()) {
    ::unlink(temporary_.c_str());
    keep_if_interrupted();
  }
}

void Output::write(std::string_view data) {
  buffer_ += data;
  if (buffer_.size() >= buffer_size) flush();
}

void Output::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(file_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

void Output::commit() {
  flush();
  if (path_.empty()) return;
  const int closed = ::close(file_);
  file_ = -1;
  if (closed != 0) fail(errno);
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
  keep_if_interrupted();
}

void Output::fail(int error) const {
  if (error == EPIPE) throw BrokenPipe();
  throw MachineError(cannot_write(path_, error));
}

void check_writable(const std::string& path) { const Output probe(path); }

}  // namespace csgcast::cli
