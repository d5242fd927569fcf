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
