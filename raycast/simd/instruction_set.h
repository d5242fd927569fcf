// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace csgcast {

/// Instructions beyond those that every processor of its kind has; each set contains the ones before it. As Highway
/// groups them: HWY_SSE4, HWY_AVX2 and HWY_AVX3.
enum class InstructionSet : std::uint8_t {
  sse4,    ///< to SSE 4.2, with AES and carry-less products
  avx2,    ///< with fused products, both sets of bit manipulation, and conversions to half precision
  avx512,  ///< F, BW, CD, DQ and VL
};

/// Whether this processor has it, and its system lets programs use it. Highway's own library tells the same, but takes
/// milliseconds to measure its clock when a program that links it starts.
bool has(InstructionSet set);

}  // namespace csgcast
