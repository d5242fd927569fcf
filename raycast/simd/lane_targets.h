// SPDX-License-Identifier: MIT
#pragma once

// The instruction sets that lanes are compiled for, or rather those that they are not: included before
// hwy/foreach_target.h, once for each file that includes itself.

// What is left out would only repeat its neighbours. Sanitizers, which take minutes for each, see the first and the
// last.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_AVX2 | HWY_SSE4)
#else
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#endif
