// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace csgcast::detail {

/// The sides of a surface that a box is seen to meet: `both` if that is not known.
enum class Sides : std::uint8_t { negative, positive, both };

}  // namespace csgcast::detail
