// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace csgcast::cli {

/// A CSV field as RFC 4180 has it: in quotes, doubled inside, if it holds a comma, a quote or a line break.
inline std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + '"';
}

}  // namespace csgcast::cli
