// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace csgcast::cli {

/// Text in aligned columns, two blanks apart: numbers to the right, words to the left, no blanks at line ends.
class Table {
 public:
  enum class Align { left, right };
  struct Column {
    std::string title;
    Align align = Align::right;
  };

  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// As many cells as there are columns.
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  /// The titles and the rows, each a line that starts with `indent`.
  void append_to(std::string& out, const std::string& indent) const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace csgcast::cli
