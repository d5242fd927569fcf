// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

// Numbers as decimal text.

namespace csgcast {

enum class NumberFault : std::uint8_t { none, no_number, out_of_range };

struct ParsedNumber {
  double value = 0;  ///< means something only without a fault
  NumberFault fault = NumberFault::none;
};

/// The double nearest to a decimal number (`1`, `-.5`, `+1e-7`, `inf`, `nan`), no blanks around it. What is too small
/// for the least double is 0, what is too large a fault. The locale does not matter.
ParsedNumber parse_number(std::string_view text);

/// Appends the shortest decimal number that reads back to the same double, as reports show it (`100000`); `inf`, `-inf`
/// or `nan` for what has none. Both zeros are `0`.
void append_number(std::string& out, double value);
std::string number(double value);

/// The number in as few characters as possible, as scene texts have it (`1e+05`); it reads back to the same double, and
/// zero keeps its sign.
std::string shortest_number(double value);

}  // namespace csgcast
