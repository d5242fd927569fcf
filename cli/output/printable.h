// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace csgcast::cli {

/// A name as tables for people show it: control characters (below 0x20, and 0x7f), which could move the cursor or start
/// a line, become `\n`, `\t`, `\r` or `\x1b`; everything else is as it is.
std::string printable(std::string_view text);

/// The text without blanks and tabs at its ends.
std::string_view trimmed(std::string_view text);

/// The text in quotes for a message: what is not printable ASCII is shown as `?`, what is long is cut.
std::string in_quotes(std::string_view text);

}  // namespace csgcast::cli
