// SPDX-License-Identifier: MIT
#pragma once

// Selects the instruction sets that lanes are compiled for, by naming those to leave out. It is included before
// hwy/foreach_target.h, once for each file that includes itself.

// The sets that are left out would only repeat their neighbours. A sanitizer build takes minutes for each set, so it
// sees the first and the last only.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_AVX2 | HWY_SSE4)
#else
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#endif
