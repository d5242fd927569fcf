// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace csgcast::text {

/// The known word nearest to a misspelt one, by Damerau's distance (letters left out, added, changed or swapped); empty
/// if none is near: more than two steps or a third of the word away.
std::string_view nearest_word(std::string_view misspelt, std::span<const std::string_view> known);

/// `did you mean 'sphere'?`, or `otherwise` if nothing is near.
std::string did_you_mean(std::string_view misspelt, std::span<const std::string_view> known, std::string otherwise);

}  // namespace csgcast::text
