// SPDX-License-Identifier: MIT
#include "cli/input/rows_option.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/input/options.h"
#include "cli/output/usage.h"

namespace csgcast::cli {
namespace {

std::vector<std::string> parse_names(const std::string& option, std::string_view text, std::size_t count) {
  std::vector<std::string> names;
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    names.emplace_back(text.substr(0, comma));
    if (comma == text.size()) break;
    text.remove_prefix(comma + 1);
  }
  const bool has_empty = std::any_of(names.begin(), names.end(), [](const std::string& name) { return name.empty(); });
  if (names.size() != count || has_empty)
    throw UsageError(fmt::format("{} takes {} names, separated by commas", option, count));
  return names;
}

}  // namespace

void add_rows_option(Command& command, RowsOption& option, const std::string& help) {
  const std::string columns = fmt::format("{}", fmt::join(option.columns, ","));
  command.add({.names = option.single_name, .value = columns, .help = help, .take = into(option.single)});
  command.add({.names = option.file_name,
               .value = "FILE.csv",
               .help = fmt::format("A CSV file with the columns {}; - is standard input", columns),
               .take = into(option.file),
               .completes = Completes::files});
  command.add({.names = "--columns",
               .value = "NAMES",
               .help = fmt::format("What the header of {} calls these columns, separated by commas; others are passed "
                                   "over (default: {})",
                                   option.file_name, columns),
               .take = into(option.header_names)});
}

void add_range_option(Command& command, RowsOption& option) {
  command.add({.names = "--rows",
               .value = "a:b",
               .help = fmt::format("Only rows a to b - 1 of {}, counted from 0; join puts the results together",
                                   option.file_name),
               .take = into(option.range)});
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
  std::vector<std::string> header_names;
  if (!option.header_names.empty()) {
    if (option.file.empty())
      throw UsageError(fmt::format("--columns needs {} (it names columns of a file)", option.file_name));
    header_names = parse_names("--columns", option.header_names, option.columns.size());
  }
  if (option.file.empty()) {
    single_ = parse_numbers(option.single_name, option.single, option.columns.size());
    return;
  }
  if (option.file == "-" && scene.path == "-") {
    throw UsageError(fmt::format("the scene and {} cannot both come from standard input", option.file_name));
  }
  file_ = std::make_unique<NumberRows>(option.file, option.columns, std::move(header_names));
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
