// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include "csg/base/place.h"

namespace csgcast {

enum class ErrorCode {
  syntax,        ///< the text does not follow the grammar
  unknown_name,  ///< no such statement, argument or colour
  wrong_type,    ///< a value of another type was needed
  bad_value,     ///< right type, impossible value
  unsupported,   ///< valid OpenSCAD that csgcast does not do yet
  limit,         ///< too deep, too many, too large
  input_output,  ///< a file that cannot be read or written where it is said to be
  usage,         ///< a call or command line that makes no sense
  machine,       ///< no fault of the input: a full disk, a file that broke off
};

/// How the libraries say that something is wrong. There are four ways:
///
/// - Bad input throws Error: whatever comes from a user, a file or another program, and is not what it should be. The
///   error has a code, the place, and a sentence that says what is wrong, why, and what to do. So have files that
///   cannot be written. A function that throws it says so.
/// - A broken precondition is a mistake in the calling program: CSGCAST_PRECONDITION (precondition.h).
/// - A call that its caller ended throws Cancelled (progress.h).
/// - Memory that runs out throws std::bad_alloc.
///
/// The libraries do not print and do not end the process, but for a broken precondition.
///
/// what() reads `file:line:column: error: what (why); what to do`.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, Place place, const std::string& problem, const std::string& why, const std::string& remedy);

  ErrorCode code() const { return code_; }
  const Place& place() const { return place_; }

 private:
  ErrorCode code_;
  Place place_;
};

/// Something odd in the input that has a defined meaning all the same.
struct Warning {
  Place place;
  std::string text;
};

/// `file:line:column: warning: text`.
std::string to_string(const Warning& warning);

}  // namespace csgcast
