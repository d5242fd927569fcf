// SPDX-License-Identifier: MIT
#include "csg/base/precondition.h"

#include <cstdio>
#include <cstdlib>

namespace csgcast {

void precondition_failed(const char* condition, const char* file, int line, const char* function) noexcept {
  static_cast<void>(std::fprintf(stderr, "%s:%d: %s: precondition failed: %s\n", file, line, function, condition));
  std::abort();
}

}  // namespace csgcast
