// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace csgcast::text {

/// The double nearest to an unsigned decimal number as the lexer cuts it (`1`, `.5`, `1.`, `1e-07`); nothing if that is
/// infinite. What is too small for the least double is 0.
std::optional<double> parse_number(std::string_view spelling);

/// The shortest decimal number that reads back to the same double; `inf`, `-inf` or `nan` for what has none.
std::string format_number(double value);

}  // namespace csgcast::text
