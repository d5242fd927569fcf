// SPDX-License-Identifier: MIT
#include "csg/base/place.h"

#include <fmt/format.h>

#include <utility>

namespace csgcast {

struct FileName::Name : Counted {
  std::string text;

  explicit Name(std::string t) : text(std::move(t)) {}
};

FileName::FileName(std::string name) {
  if (!name.empty()) name_ = Shared<Name>::make(std::move(name));
}

const std::string& FileName::string() const {
  static const std::string none;
  return name_ ? name_->text : none;
}

std::string to_string(const Place& place) {
  if (place.line == 0) return place.file.string();
  return fmt::format("{}:{}:{}", place.file.empty() ? "<scene>" : place.file.string(), place.line, place.column);
}

}  // namespace csgcast
