// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace csgcast::text {

/// A word of the scene text (UTF-8) as a message quotes it: more than 40 bytes are cut there, between two characters,
/// and end in `...`.
std::string shortened(std::string_view word);

}  // namespace csgcast::text
