// SPDX-License-Identifier: MIT
#include "cli/output/output.h"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "csg/base/error.h"

namespace csgcast::cli {
namespace {

constexpr std::size_t buffer_size = 1 << 16;

void write_to_standard_output(std::string_view data) {
  if (std::fwrite(data.data(), 1, data.size(), stdout) == data.size() && std::fflush(stdout) == 0) return;
  if (errno == EPIPE) throw BrokenPipe();
  throw Error(ErrorCode::machine, {}, "cannot write standard output", std::generic_category().message(errno),
              "make room or choose another place");
}

}  // namespace

Output::Output(const std::string& path) {
  if (!path.empty()) file_.emplace(path);
}

void Output::write(std::string_view data) {
  if (buffer_.size() + data.size() < buffer_size) {
    buffer_ += data;
    return;
  }
  flush();
  put(data);
}

void Output::write(std::span<const std::byte> data) {
  write(std::string_view(reinterpret_cast<const char*>(data.data()), data.size()));
}

void Output::flush() {
  put(buffer_);
  buffer_.clear();
}

void Output::put(std::string_view data) {
  if (!file_) return write_to_standard_output(data);
  try {
    file_->write(data);
  } catch (const Error&) {
    if (file_->has_lost_reader()) throw BrokenPipe();
    throw;
  }
}

void Output::commit() {
  flush();
  if (file_) file_->commit();
}

}  // namespace csgcast::cli
