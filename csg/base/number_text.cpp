// SPDX-License-Identifier: MIT
#include "csg/base/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <system_error>

namespace csgcast {
namespace {

/// The exponent as written, limited to ±10^18 so that sums with it do not overflow.
std::int64_t written_exponent(std::string_view digits) {
  constexpr std::int64_t limit = 1'000'000'000'000'000'000;
  const bool negative = digits.starts_with('-');
  if (negative || digits.starts_with('+')) digits.remove_prefix(1);
  std::int64_t exponent = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  if (result.ec != std::errc() || exponent > limit) exponent = limit;
  return negative ? -exponent : exponent;
}

/// True if a non-zero number is at least 1. Then its first non-zero digit is before the point.
bool at_least_one(std::string_view spelling) {
  const std::size_t mark = spelling.find_first_of("eE");
  const std::string_view mantissa = spelling.substr(0, mark);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_of("123456789");
  const auto before_point = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  const std::int64_t exponent = mark == std::string_view::npos ? 0 : written_exponent(spelling.substr(mark + 1));
  return before_point + exponent > 0;
}

}  // namespace

ParsedNumber parse_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  ParsedNumber parsed;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, parsed.value);
  if (stop != end || error == std::errc::invalid_argument) return {0, NumberFault::no_number};
  // Too large or too small: from_chars does not say which.
  if (error == std::errc::result_out_of_range)
    return {0, at_least_one(text) ? NumberFault::out_of_range : NumberFault::none};
  return parsed;
}

void append_number(std::string& out, double value) {
  fmt::format_to(std::back_inserter(out), "{}", value == 0 ? 0.0 : value);
}

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string shortest_number(double value) {
  if (std::isnan(value)) return "nan";
  std::array<char, 32> buffer{};  // the shortest form of a double takes at most 24 characters
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

}  // namespace csgcast
