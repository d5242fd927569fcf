// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

// Functions of up to six truth values as words of 64 bits: bit s is the value where the i-th of them is bit i of s.

namespace csgcast {

/// The states in which the i-th is true.
constexpr std::uint64_t positive_states(std::size_t i) {
  constexpr std::array<std::uint64_t, 6> words{0xaaaaaaaaaaaaaaaau, 0xccccccccccccccccu, 0xf0f0f0f0f0f0f0f0u,
                                               0xff00ff00ff00ff00u, 0xffff0000ffff0000u, 0xffffffff00000000u};
  return words[i];
}

/// The table where the i-th has one value: it no longer depends on it.
constexpr std::uint64_t restricted(std::uint64_t table, std::size_t i, bool value) {
  const std::uint64_t states = positive_states(i);
  const std::uint64_t shift = std::uint64_t{1} << i;
  if (value) return (table & states) | (table & states) >> shift;
  return (table & ~states) | (table & ~states) << shift;
}

constexpr bool depends_on(std::uint64_t table, std::size_t i) {
  return restricted(table, i, false) != restricted(table, i, true);
}

/// The i-th becomes the j-th, on which the table must not depend unless it is the same one.
constexpr std::uint64_t renamed(std::uint64_t table, std::size_t i, std::size_t j) {
  if (i == j) return table;
  return (restricted(table, i, true) & positive_states(j)) | (restricted(table, i, false) & ~positive_states(j));
}

}  // namespace csgcast
