// SPDX-License-Identifier: MIT
#include "cli/number.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>

namespace csgcast::cli {

void append_number(std::string& out, double value) {
  fmt::format_to(std::back_inserter(out), "{}", value == 0 ? 0.0 : value);
}

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

ParsedNumber parse_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  ParsedNumber parsed;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, parsed.value);
  if (stop != end || error == std::errc::invalid_argument) return {0, NumberFault::no_number};
  if (error == std::errc::result_out_of_range) {  // too large or too small: from_chars does not say which
    parsed.value = std::strtod(std::string(text).c_str(), nullptr);
    if (std::isinf(parsed.value)) parsed.fault = NumberFault::out_of_range;
  }
  return parsed;
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
