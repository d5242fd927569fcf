// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

namespace csgcast {

/// False, true, or not known (Kleene's logic). The values are in this order so that the least of several values is true
/// if all of them are, and the greatest is true if one of them is.
enum class Truth : std::uint8_t { no, unknown, yes };

constexpr Truth truth(bool value) { return value ? Truth::yes : Truth::no; }
constexpr Truth opposite(Truth value) { return value == Truth::unknown ? value : truth(value == Truth::no); }

}  // namespace csgcast
