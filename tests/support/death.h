// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

namespace csgcast::test {

/// How a piece of work ended that ran in a process of its own.
struct Ending {
  bool aborted = false;
  std::string printed;  ///< to standard output and standard error
};

/// Runs `work` in a fork, which starts no threads of its own before.
Ending ending_of(const std::function<void()>& work);

}  // namespace csgcast::test
