// SPDX-License-Identifier: MIT
#include "csg/file/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "csg/base/error.h"
#include "csg/base/precondition.h"
#include "csg/file/link_target.h"

namespace csgcast {

/// The name of an unfinished file, in a list that only grows, where a signal handler finds it. A place is used again.
/// Its name changes only while it is not armed.
struct WholeFile::Unfinished {
  std::array<char, 4096> name{};
  std::atomic<bool> is_taken = true;
  std::atomic<bool> is_armed = false;  // true if the file may exist
  Unfinished* next = nullptr;

  static std::atomic<Unfinished*> first;

  static Unfinished* take() {
    for (Unfinished* place = first.load(); place != nullptr; place = place->next) {
      if (!place->is_taken.exchange(true)) return place;
    }
    auto* const place = new Unfinished;  // NOLINT(cppcoreguidelines-owning-memory): stays for the handler
    place->next = first.load();
    while (!first.compare_exchange_weak(place->next, place)) {
    }
    return place;
  }
  void give_back() {
    is_armed.store(false);
    is_taken.store(false);
  }

  /// False if the name is too long.
  bool arm(const std::string& text) {
    is_armed.store(false);
    if (text.size() >= name.size()) return false;
    *std::copy(text.begin(), text.end(), name.begin()) = '\0';
    is_armed.store(true);
    return true;
  }
};

std::atomic<WholeFile::Unfinished*> WholeFile::Unfinished::first = nullptr;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<void*>::is_always_lock_free);

namespace {

/// True for failures of the machine, as opposed to a path that makes no sense.
bool is_machine_failure(int error) {
  constexpr std::array failures{ENOSPC, EDQUOT, EFBIG, EIO, ENOMEM, EMFILE, ENFILE};
  return std::find(failures.begin(), failures.end(), error) != failures.end();
}

std::string text_of(int error) { return std::generic_category().message(error); }

[[noreturn]] void machine_failed(const std::string& path, int error) {
  throw Error(ErrorCode::machine, {path, 0, 0}, "cannot write this file", text_of(error),
              "make room or choose another place");
}

[[noreturn]] void cannot_open(const std::string& path, int error) {
  if (is_machine_failure(error)) machine_failed(path, error);
  throw Error(ErrorCode::input_output, {path, 0, 0}, "cannot write this file", text_of(error),
              "choose a path in a folder that exists and may be written");
}

}  // namespace

WholeFile::WholeFile(const std::string& path) : path_(path), target_(link_target(path)) {
  struct stat existing {};
  const bool exists = ::stat(target_.c_str(), &existing) == 0;
  if (!exists && errno == ELOOP) cannot_open(path_, ELOOP);
  if (exists && S_ISDIR(existing.st_mode)) cannot_open(path_, EISDIR);
  if (exists && !S_ISREG(existing.st_mode)) {
    file_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) cannot_open(path_, errno);
    return;
  }
  if (exists && ::access(target_.c_str(), W_OK) != 0) cannot_open(path_, errno);
  unfinished_ = Unfinished::take();
  open_beside(exists ? std::optional(existing.st_mode & 0777u) : std::nullopt);
  if (file_ >= 0) return;
  const int error = errno;
  unfinished_->give_back();
  cannot_open(path_, error);
}

/// Creates a new file in the target's folder, with the permissions of an older one. If that fails, there is no file,
/// and errno is set.
void WholeFile::open_beside(std::optional<unsigned> permissions) {
  const std::string folder = std::filesystem::path(target_).parent_path().string();
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const std::string name = fmt::format("{}/.csgcast-{}-{}", folder.empty() ? "." : folder, ::getpid(), attempt);
    // Another file of this process may have the name, and the handler may remove that file twice.
    if (!unfinished_->arm(name)) {
      errno = ENAMETOOLONG;
      return;
    }
    file_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions.value_or(0666));
    if (file_ < 0 && errno == EEXIST) continue;
    // Keeping the permissions is a courtesy. A file system without permissions is no reason to stop.
    if (file_ >= 0 && permissions) static_cast<void>(::fchmod(file_, *permissions));
    return;
  }
}

WholeFile::~WholeFile() {
  if (file_ >= 0) ::close(file_);
  if (unfinished_ == nullptr) return;
  ::unlink(unfinished_->name.data());
  unfinished_->give_back();
}

void WholeFile::write(std::string_view data) {
  CSGCAST_PRECONDITION(file_ >= 0);
  while (!data.empty()) {
    const ssize_t written = ::write(file_, data.data(), data.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    data.remove_prefix(static_cast<std::size_t>(written));
  }
}

void WholeFile::write(std::span<const std::byte> data) {
  write(std::string_view(reinterpret_cast<const char*>(data.data()), data.size()));
}

void WholeFile::commit() {
  CSGCAST_PRECONDITION(file_ >= 0);
  const int closed = ::close(file_);
  file_ = -1;
  if (closed != 0) fail(errno);
  if (unfinished_ == nullptr) return;
  if (::rename(unfinished_->name.data(), target_.c_str()) != 0) fail(errno);
  unfinished_->give_back();
  unfinished_ = nullptr;
}

void WholeFile::fail(int error) {
  has_lost_reader_ = error == EPIPE;
  machine_failed(path_, error);
}

void remove_unfinished_files() noexcept {
  const int before = errno;
  for (auto* place = WholeFile::Unfinished::first.load(); place != nullptr; place = place->next) {
    if (place->is_armed.load()) ::unlink(place->name.data());
  }
  errno = before;
}

}  // namespace csgcast
