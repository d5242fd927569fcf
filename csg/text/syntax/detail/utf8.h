// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace csgcast::text {

/// The code point that `bytes` starts with; nothing if they are no well-formed UTF-8 (overlong forms and surrogates are
/// not). RFC 3629.
std::optional<std::uint32_t> first_code_point(std::string_view bytes);

/// Appends a code point in UTF-8. False, and nothing appended, for a surrogate or a number above 0x10ffff.
bool append_code_point(std::string& text, std::uint32_t code_point);

}  // namespace csgcast::text
