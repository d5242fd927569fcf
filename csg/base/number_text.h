// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

// Numbers as decimal text.

namespace csgcast {

enum class NumberFault : std::uint8_t { none, no_number, out_of_range };

struct ParsedNumber {
  double value = 0;  ///< valid only if there is no fault
  NumberFault fault = NumberFault::none;
};

/// The double nearest to a decimal number (`1`, `-.5`, `+1e-7`, `inf`, `nan`), without blanks around it. A number too
/// small for the least double is read as 0. A number that is too large is a fault. The locale does not matter.
ParsedNumber parse_number(std::string_view text);

/// Appends the shortest decimal number that reads back to the same double, in the form for reports (`100000`). Infinity
/// and NaN are `inf`, `-inf` and `nan`. Both zeros are `0`.
void append_number(std::string& out, double value);
std::string number(double value);

/// The number in as few characters as possible, in the form for scene texts (`1e+05`). It reads back to the same
/// double, and zero keeps its sign.
std::string shortest_number(double value);

}  // namespace csgcast
