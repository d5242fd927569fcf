// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace csgcast::detail {

/// The sides of a surface that a box meets, as far as is known. If it is not known, `both`.
enum class Sides : std::uint8_t { negative, positive, both };

}  // namespace csgcast::detail
