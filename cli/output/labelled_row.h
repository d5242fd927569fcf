// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace csgcast::cli {

/// A line of a report: a name, or nothing, and what it is.
inline void append_row(std::string& out, std::string_view name, const std::string& content) {
  out += fmt::format("{:<12}{}\n", name, content);
}

/// `1 part`, `2 parts`.
inline std::string counted(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace csgcast::cli
