// SPDX-License-Identifier: MIT
#include "cli/input/options.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "cli/output/printable.h"
#include "cli/output/usage.h"
#include "csg/base/number_text.h"

namespace csgcast::cli {
namespace {

double parse_one(const std::string& option, std::string_view text) {
  const ParsedNumber parsed = parse_number(trimmed(text));
  if (parsed.fault == NumberFault::no_number) {
    throw UsageError(fmt::format("{}: {} is no number", option, in_quotes(text)));
  }
  if (parsed.fault == NumberFault::out_of_range) {
    throw UsageError(fmt::format("{}: {} is beyond the range of double", option, in_quotes(text)));
  }
  return parsed.value;
}

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Whether the text is an integer, maybe one too large for int.
bool is_integer(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

std::vector<double> parse_numbers(const std::string& option, const std::string& text) {
  std::vector<double> numbers;
  std::string_view rest = text;
  while (true) {
    const std::size_t comma = rest.find(',');
    const double value = parse_one(option, rest.substr(0, comma));
    if (!std::isfinite(value)) {
      throw UsageError(fmt::format("{}: {} is not finite", option, in_quotes(rest.substr(0, comma))));
    }
    numbers.push_back(value);
    if (comma == std::string_view::npos) return numbers;
    rest.remove_prefix(comma + 1);
  }
}

std::vector<double> parse_numbers(const std::string& option, const std::string& text, std::size_t count) {
  std::vector<double> numbers = parse_numbers(option, text);
  if (numbers.size() != count) {
    throw UsageError(fmt::format("{} needs {} numbers separated by commas, not {}", option, count, numbers.size()));
  }
  return numbers;
}

double parse_parameter(const std::string& option, const std::string& text) {
  const double value = parse_one(option, text);
  if (std::isnan(value)) throw UsageError(fmt::format("{}: {} is no place on a ray", option, in_quotes(text)));
  return value;
}

int parse_count(const std::string& option, const std::string& text, int low, int high) {
  const std::optional<int> value = whole_number(text);
  if (!value && !is_integer(text)) throw UsageError(fmt::format("{}: {} is no whole number", option, in_quotes(text)));
  if (!value || *value < low || *value > high) {
    throw UsageError(fmt::format("{}: {} is out of range ({} to {})", option, in_quotes(text), low, high));
  }
  return *value;
}

std::pair<int, int> parse_pair(const std::string& option, const std::string& text, char mark, int low, int high) {
  const std::size_t middle = text.find(mark);
  if (middle == std::string::npos) {
    throw UsageError(fmt::format("{}: {} has no '{}' between two whole numbers", option, in_quotes(text), mark));
  }
  return {parse_count(option, text.substr(0, middle), low, high),
          parse_count(option, text.substr(middle + 1), low, high)};
}

}  // namespace csgcast::cli
