// SPDX-License-Identifier: MIT
#include "shade/picture/detail/srgb_bytes.h"

#include <cmath>
#include <limits>

#include "csg/solid/look.h"
#include "shade/picture/detail/encode.h"

namespace csgcast::detail {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

int byte_of(float linear) { return to_byte(srgb_from_linear(linear)); }

/// The inverse of the curve is right but for some roundings; the rest of the way is walked.
float start_of(int byte) {
  float x = static_cast<float>(linear_from_srgb((byte - 0.5) / 255));
  while (byte_of(x) < byte) x = std::nextafter(x, infinity);
  while (byte_of(std::nextafter(x, 0.0F)) >= byte) x = std::nextafter(x, 0.0F);
  return x;
}

}  // namespace

SrgbBytes::SrgbBytes() : least_(std::bit_cast<std::uint32_t>(1.0F) >> dropped_bits) {
  for (int byte = 1; byte < 256; ++byte) starts_[byte] = start_of(byte);
  starts_[256] = infinity;
  std::uint8_t byte = 0;
  for (std::uint32_t range = 0; range < least_.size(); ++range) {
    while (std::bit_cast<float>(range << dropped_bits) >= starts_[byte + 1]) ++byte;
    least_[range] = byte;
  }
}

}  // namespace csgcast::detail
