// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace csgcast::cli {

/// Appends the shortest decimal number that reads back to the same double; `inf`, `-inf` or `nan` for what has none.
/// Both zeros are `0`.
void append_number(std::string& out, double value);
std::string number(double value);

enum class NumberFault : std::uint8_t { none, no_number, out_of_range };

struct ParsedNumber {
  double value = 0;  ///< means something only without a fault
  NumberFault fault = NumberFault::none;
};

/// The double nearest to a decimal number (`1`, `-.5`, `+1e-7`, `inf`, `nan`), no blanks around it. What is too small
/// for the least double is 0, what is too large a fault.
ParsedNumber parse_number(std::string_view text);

/// The text without blanks and tabs at its ends.
std::string_view trimmed(std::string_view text);

/// The text in quotes for a message: what is not printable ASCII is shown as `?`, what is long is cut.
std::string in_quotes(std::string_view text);

}  // namespace csgcast::cli
