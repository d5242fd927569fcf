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

/// The libraries report that something is wrong in one of four ways:
///
/// - Bad input throws Error. Bad input is anything from a user, a file or another program that is not what it should
///   be. The error has a code, the place, and a sentence that says what is wrong, why, and what to do. A file that
///   cannot be written also throws Error. Each function that throws it says so.
/// - A broken precondition is a mistake in the calling program: CSGCAST_PRECONDITION (precondition.h).
/// - A call that its caller cancelled throws Cancelled (progress.h).
/// - If memory runs out, std::bad_alloc is thrown.
///
/// The libraries do not print. They do not end the process, except for a broken precondition.
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

/// Something odd in the input that nevertheless has a defined meaning.
struct Warning {
  Place place;
  std::string text;
};

/// `file:line:column: warning: text`.
std::string to_string(const Warning& warning);

}  // namespace csgcast
