// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

namespace csgcast {

/// The name of a file. Copies share it: every node of a large scene has a place, and all are in one file.
class FileName {
 public:
  FileName() = default;
  FileName(std::string name);  // NOLINT(google-explicit-constructor): a name is a string that is cheap to copy
  FileName(const char* name) : FileName(std::string(name)) {}  // NOLINT(google-explicit-constructor)

  const std::string& string() const;
  bool empty() const { return name_ == nullptr; }
  friend bool operator==(const FileName& a, const FileName& b) {
    return a.name_ == b.name_ || a.string() == b.string();
  }

 private:
  std::shared_ptr<const std::string> name_;  // null: empty
};

/// Where in a scene text something stands; line 0 means that no place is known. Lines and columns count from 1, columns
/// in bytes.
struct Place {
  FileName file;
  int line = 0;
  int column = 0;
  friend bool operator==(const Place&, const Place&) = default;
};

/// `file:line:column`, or what is known of it.
std::string to_string(const Place& place);

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
