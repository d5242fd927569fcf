// SPDX-License-Identifier: MIT
#include "cli/output/printable.h"

#include <fmt/format.h>

namespace csgcast::cli {

std::string printable(std::string_view text) {
  std::string shown;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\n') {
      shown += "\\n";
    } else if (c == '\t') {
      shown += "\\t";
    } else if (c == '\r') {
      shown += "\\r";
    } else if (byte < 0x20 || byte == 0x7f) {
      shown += fmt::format("\\x{:02x}", byte);
    } else {
      shown += c;
    }
  }
  return shown;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t enough = 40;
  std::string shown;
  for (const char c : text.substr(0, enough)) shown += c >= 0x20 && c < 0x7f ? c : '?';
  return fmt::format("'{}{}'", shown, text.size() > enough ? "..." : "");
}

}  // namespace csgcast::cli
