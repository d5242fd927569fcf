// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <string_view>

namespace csgcast::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool is_sanitized = true;  ///< everything takes some ten times as long
#else
constexpr bool is_sanitized = false;
#endif

/// How often a test repeats what it does. Sanitizers need to see it only once, so they get an eighth.
constexpr int times(int plain) { return is_sanitized ? (plain + 7) / 8 : plain; }

/// Of a test's cases that differ in several ways at once: every how many of them it takes. No small number divides it.
constexpr int stride = is_sanitized ? 7 : 1;

/// Whether CSGCAST_LONG=1 asks for the long run of a test.
inline bool long_run() {
  const char* variable = std::getenv("CSGCAST_LONG");
  return variable != nullptr && std::string_view(variable) == "1";
}

}  // namespace csgcast::test
