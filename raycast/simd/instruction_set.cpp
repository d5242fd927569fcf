// SPDX-License-Identifier: MIT
#include "raycast/simd/instruction_set.h"

#if defined(__x86_64__)
#include <cpuid.h>
#endif

namespace csgcast {

#if defined(__x86_64__)

namespace {

bool has_sse4() {
  return __builtin_cpu_supports("ssse3") != 0 && __builtin_cpu_supports("sse4.1") != 0 &&
         __builtin_cpu_supports("sse4.2") != 0 && __builtin_cpu_supports("popcnt") != 0 &&
         __builtin_cpu_supports("aes") != 0 && __builtin_cpu_supports("pclmul") != 0;
}

// Not every compiler's __builtin_cpu_supports knows these two.
bool has_lzcnt_and_f16c() {
  unsigned a = 0;
  unsigned b = 0;
  unsigned c = 0;
  unsigned d = 0;
  constexpr unsigned f16c = 1u << 29u;
  constexpr unsigned lzcnt = 1u << 5u;
  if (__get_cpuid(1, &a, &b, &c, &d) == 0 || (c & f16c) == 0) return false;
  return __get_cpuid(0x80000001u, &a, &b, &c, &d) != 0 && (c & lzcnt) != 0;
}

bool has_avx2() {
  return has_sse4() && __builtin_cpu_supports("avx") != 0 && __builtin_cpu_supports("avx2") != 0 &&
         __builtin_cpu_supports("fma") != 0 && __builtin_cpu_supports("bmi") != 0 &&
         __builtin_cpu_supports("bmi2") != 0 && has_lzcnt_and_f16c();
}

bool has_avx512() {
  return has_avx2() && __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
         __builtin_cpu_supports("avx512cd") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
         __builtin_cpu_supports("avx512vl") != 0;
}

}  // namespace

bool has(InstructionSet set) {
  switch (set) {
    case InstructionSet::sse4:
      return has_sse4();
    case InstructionSet::avx2:
      return has_avx2();
    case InstructionSet::avx512:
      return has_avx512();
  }
  return false;
}

#else

bool has(InstructionSet) { return false; }

#endif

}  // namespace csgcast
