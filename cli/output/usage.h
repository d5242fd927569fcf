// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace csgcast::cli {

/// A command line that makes no sense. what() is the problem alone, with its reason; main adds the program's name and
/// where to find help. Exit code 2.
class UsageError : public std::runtime_error {
  using runtime_error::runtime_error;
};

/// The machine failed, not the input: a full disk, an output that broke off. what() is a whole line as Error's is. Exit
/// code 1.
class MachineError : public std::runtime_error {
  using runtime_error::runtime_error;
};

}  // namespace csgcast::cli
