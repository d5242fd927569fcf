// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "csg/base/shared.h"

namespace csgcast {

/// The name of a file. Copies share the string, because every node of a large scene has a place, and all are in one
/// file.
class FileName {
 public:
  FileName() = default;
  FileName(std::string name);  // NOLINT(google-explicit-constructor): a name is a string that is cheap to copy
  FileName(const char* name) : FileName(std::string(name)) {}  // NOLINT(google-explicit-constructor)

  const std::string& string() const;
  bool empty() const { return !name_; }
  friend bool operator==(const FileName& a, const FileName& b) {
    return a.name_ == b.name_ || a.string() == b.string();
  }

 private:
  struct Name;
  Shared<Name> name_;  // none: empty
};

/// A place in a scene text. Line 0 means that no place is known. Lines and columns count from 1, and columns count
/// bytes.
struct Place {
  FileName file;
  int line = 0;
  int column = 0;
  friend bool operator==(const Place&, const Place&) = default;
};

/// `file:line:column`, or the part of it that is known.
std::string to_string(const Place& place);

}  // namespace csgcast
