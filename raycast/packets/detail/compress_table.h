// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace csgcast::detail {

/// For each set of eight lanes, given by one bit each: the numbers of the lanes in the set, the lowest first, then
/// zeros.
using CompressTable = std::array<std::array<std::uint8_t, 8>, 256>;

constexpr CompressTable make_compress_table() {
  CompressTable table{};
  for (std::size_t bits = 0; bits < table.size(); ++bits) {
    std::size_t count = 0;
    for (std::uint8_t lane = 0; lane < 8; ++lane) {
      if ((bits >> lane & 1) != 0) table[bits][count++] = lane;
    }
  }
  return table;
}

inline constexpr CompressTable compress_table = make_compress_table();

}  // namespace csgcast::detail
