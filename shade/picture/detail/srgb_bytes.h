// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace csgcast::detail {

/// to_byte(srgb_from_linear(x)) of any float, without pow: a picture asks for a million of them.
class SrgbBytes {
 public:
  /// Takes a twentieth of a millisecond.
  SrgbBytes();

  std::uint8_t operator()(float linear) const {
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 255;
    const unsigned byte = least_[std::bit_cast<std::uint32_t>(linear) >> dropped_bits];
    return static_cast<std::uint8_t>(byte + (linear >= starts_[byte + 1] ? 1 : 0));
  }

 private:
  /// Floats below 1 fall into ranges, 128 an octave: all whose bits are the same above these. The curve rises by at
  /// most 0.7 bytes over one (1/256 long, from 1/2 on, where its slope is 168 bytes), so that a range meets at most two
  /// bytes.
  static constexpr int dropped_bits = 16;

  std::array<float, 257> starts_{};  ///< the least float of each byte; infinite after the last
  std::vector<std::uint8_t> least_;  ///< the byte of the least float of each range
};

}  // namespace csgcast::detail
