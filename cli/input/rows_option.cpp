// SPDX-License-Identifier: MIT
#include "cli/input/rows_option.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/input/options.h"

namespace csgcast::cli {

void add_rows_option(CLI::App& line, RowsOption& option, const std::string& help) {
  const std::string columns = fmt::format("{}", fmt::join(option.columns, ","));
  line.add_option(option.single_name, option.single, help)->type_name(columns);
  line.add_option(option.file_name, option.file,
                  fmt::format("A CSV file with the columns {}, - for standard input", columns))
      ->type_name("FILE.csv");
}

void add_range_option(CLI::App& line, RowsOption& option) {
  line.add_option(
          "--rows", option.range,
          fmt::format("Only rows a to b - 1 of {}, counted from 0; join puts the results together", option.file_name))
      ->type_name("a:b");
}

Rows::Rows(const RowsOption& option, const SceneOptions& scene)
    : option_(option), progress_(option.file_name.substr(2), scene.progress()) {
  if (option.single.empty() == option.file.empty()) {
    throw UsageError(fmt::format("exactly one of {} and {} is needed", option.single_name, option.file_name));
  }
  if (!option.range.empty()) {
    range_ = parse_rows("--rows", option.range);
    if (option.file.empty())
      throw UsageError(fmt::format("--rows needs {} (it takes rows of a file)", option.file_name));
  }
  if (option.file.empty()) {
    single_ = parse_numbers(option.single_name, option.single, option.columns.size());
    return;
  }
  if (option.file == "-" && scene.path == "-") {
    throw UsageError(fmt::format("the scene and {} cannot both come from standard input", option.file_name));
  }
  file_ = std::make_unique<NumberRows>(option.file, option.columns);
}

void Rows::skip_to_first() {
  is_begun_ = true;
  while (file_->count() < range_.first && file_->skip()) {
  }
  if (file_->count() < range_.first) {
    throw Error(ErrorCode::usage, {file_->file(), 0, 0}, fmt::format("there are no rows from {} on", range_.first),
                fmt::format("the file has {}", file_->count()), "give --rows within the file");
  }
}

bool Rows::next(NumberRow& row) {
  if (file_) {
    progress_.update(file_->share_read());
    if (!is_begun_) skip_to_first();
    if (is_done_) return false;
    if (file_->count() < range_.end && file_->next(row)) return true;
    is_done_ = true;
    const std::uint64_t end = file_->count();
    range_.is_last = end < range_.end || !file_->skip();
    range_.end = end;
    return false;
  }
  if (single_.empty()) return false;
  row = {};
  std::copy(single_.begin(), single_.end(), row.values.begin());
  single_.clear();
  return true;
}

void Rows::reject(const NumberRow& row, std::size_t column, const std::string& problem, const std::string& why,
                  const std::string& remedy) const {
  if (!file_) throw UsageError(fmt::format("{}: {} ({})", option_.single_name, problem, why));
  throw Error(ErrorCode::bad_value, {file_->file(), row.line, row.columns[column]}, problem, why, remedy);
}

}  // namespace csgcast::cli
