// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace csgcast {

/// Instructions beyond those that every processor of its kind has. Each set contains the sets before it. The groups are
/// those of Highway: HWY_SSE4, HWY_AVX2 and HWY_AVX3.
enum class InstructionSet : std::uint8_t {
  sse4,    ///< to SSE 4.2, with AES and carry-less products
  avx2,    ///< with fused products, both sets of bit manipulation, and conversions to half precision
  avx512,  ///< F, BW, CD, DQ and VL
};

/// True if this processor has the set, and its system lets programs use it. Highway's own library tells the same, but
/// it takes milliseconds to measure its clock at the start of any program that links it.
bool has(InstructionSet set);

}  // namespace csgcast
