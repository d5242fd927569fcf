// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/input/scene_input.h"
#include "csg/text/syntax/syntax.h"

namespace csgcast::cli {

/// What a part of a result was made from: scene and options, as names and values. Parts of one result have the same
/// label. Names are words; values have no line break, no semicolon and no quotes.
class PartLabel {
 public:
  PartLabel() = default;
  /// The scene, by a hash of its statements and their places, and what was asked for of it.
  PartLabel(const text::Document& document, const SceneOptions& options);

  void add(std::string name, std::string value) { entries_.emplace_back(std::move(name), std::move(value)); }
  const std::vector<std::pair<std::string, std::string>>& entries() const { return entries_; }

  /// `name value; name value`.
  std::string text() const;
  /// The same from such a text.
  static PartLabel from(std::string_view text);
  /// The name of the first entry that another label does not have alike; empty if they are equal.
  std::string difference(const PartLabel& other) const;

 private:
  std::vector<std::pair<std::string, std::string>> entries_;
};

/// The file of a part, to read. Throws Error(input_output) if it cannot be opened.
std::ifstream open_part(const std::string& path);

/// Throws Error(usage) if two parts were not made from the same scene with the same options.
void check_alike(const std::string& path, const PartLabel& label, const std::string& first_path,
                 const PartLabel& first);

}  // namespace csgcast::cli
