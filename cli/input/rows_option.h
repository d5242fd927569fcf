// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cli/input/command.h"
#include "cli/input/number_rows.h"
#include "cli/input/row_parts.h"
#include "cli/input/row_pipeline.h"
#include "cli/input/scene_input.h"
#include "cli/output/progress_bar.h"

namespace csgcast::cli {

/// A pair of options of which one is needed: one row of numbers on the command line (`--ray`), or a file of them
/// (`--rays`).
struct RowsOption {
  std::string single_name;  ///< `--ray`
  std::string file_name;    ///< `--rays`
  std::vector<std::string> columns;
  std::string single;  ///< what was given
  std::string file;
  std::string header_names{};  ///< `--columns`: what the header of the file calls the columns
  std::string range{};         ///< `--rows`: those of the file alone; empty: all
};

/// `option` must live as long as `command`.
void add_rows_option(Command& command, RowsOption& option, const std::string& help);
/// The option --rows.
void add_range_option(Command& command, RowsOption& option);

/// The rows that the options ask for. Made before the scene is read, it finds what is wrong with them at once.
class Rows {
 public:
  /// Throws UsageError if not exactly one of the two is given, or both scene and rows are to come from standard input;
  /// and what parse_numbers() and NumberRows throw.
  Rows(const RowsOption& option, const SceneOptions& scene);

  /// The rows asked for; at the end those that there were.
  const RowRange& range() const { return range_; }
  /// The next row; draws the progress bar. Throws as NumberRows does.
  bool next(NumberRow& row);
  /// Error about one number of a row: with its place in the file, or with the option's name.
  [[noreturn]] void reject(const NumberRow& row, std::size_t column, const std::string& problem, const std::string& why,
                           const std::string& remedy) const;

 private:
  void skip_to_first();

  const RowsOption& option_;
  RowRange range_;
  bool is_begun_ = false;
  bool is_done_ = false;
  ProgressBar progress_;
  std::unique_ptr<NumberRows> file_;
  std::vector<double> single_;
};

}  // namespace csgcast::cli
