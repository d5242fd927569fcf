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
  input_output,  ///< a file could not be read or written
  usage,         ///< a call or command line that makes no sense
};

/// Bad input. what() reads `file:line:column: error: what (why); what to do`.
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
