// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"

namespace csgcast::test {

/// The names of examples/*.csg, in alphabetical order.
inline std::vector<std::string> example_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(CSGCAST_SOURCE_DIR "/examples"))
    if (entry.path().extension() == ".csg") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// examples/`name`.csg.
inline SceneDescription example(const std::string& name) {
  return text::build(text::read_file(CSGCAST_SOURCE_DIR "/examples/" + name + ".csg"));
}

}  // namespace csgcast::test
