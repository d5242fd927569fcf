// SPDX-License-Identifier: MIT
#pragma once

/// CSGCAST_PRECONDITION(condition) checks what the caller of a function promises. A broken promise is a mistake in the
/// program, not bad input (see error.h). The file, line, function and condition are printed, and the process aborts.
///
/// CMake's option CSGCAST_CHECK_PRECONDITIONS enables the checks for the libraries and for all code that links them. It
/// is on in debug and sanitizer builds. If it is off, the condition is compiled but not evaluated.
#if defined(CSGCAST_CHECK_PRECONDITIONS)
#define CSGCAST_PRECONDITION(...) \
  ((__VA_ARGS__)                  \
       ? static_cast<void>(0)     \
       : ::csgcast::precondition_failed(#__VA_ARGS__, __FILE__, __LINE__, static_cast<const char*>(__func__)))
#else
#define CSGCAST_PRECONDITION(...) static_cast<void>(sizeof((__VA_ARGS__) ? 1 : 0))
#endif

namespace csgcast {

/// Prints `FILE:LINE: FUNCTION: precondition failed: CONDITION` to standard error and aborts.
[[noreturn]] void precondition_failed(const char* condition, const char* file, int line, const char* function) noexcept;

}  // namespace csgcast
