// SPDX-License-Identifier: MIT
#include "csg/base/error.h"

#include <fmt/format.h>

#include <utility>

namespace csgcast {
namespace {

std::string prefix(const Place& place) {
  const std::string at = to_string(place);
  return at.empty() ? "csgcast" : at;
}

std::string message(const Place& place, const std::string& problem, const std::string& why, const std::string& remedy) {
  std::string text = fmt::format("{}: error: {}", prefix(place), problem);
  if (!why.empty()) text += fmt::format(" ({})", why);
  if (!remedy.empty()) text += fmt::format("; {}", remedy);
  return text;
}

}  // namespace

Error::Error(ErrorCode code, Place place, const std::string& problem, const std::string& why, const std::string& remedy)
    : std::runtime_error(message(place, problem, why, remedy)), code_(code), place_(std::move(place)) {}

std::string to_string(const Warning& warning) {
  return fmt::format("{}: warning: {}", prefix(warning.place), warning.text);
}

}  // namespace csgcast
