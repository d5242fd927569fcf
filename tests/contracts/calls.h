// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "csg/base/progress.h"

namespace csgcast::test {

/// A call that takes long.
struct LongCall {
  std::string name;
  std::function<std::string(const ProgressCallback&)> run;  ///< returns all of the result as a text
};

/// Every function of the libraries that takes a ProgressCallback, on a small model: new ones belong here.
std::vector<LongCall> long_calls();

/// Those that have an option `threads`, with the number to set it to.
struct CallOnThreads {
  std::string name;
  std::function<std::string(int threads, const ProgressCallback&)> run;
};
std::vector<CallOnThreads> calls_with_threads();

}  // namespace csgcast::test
