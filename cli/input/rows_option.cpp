// SPDX-License-Identifier: MIT
#include "cli/input/rows_option.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/input/options.h"
#include "cli/output/usage.h"

namespace csgcast::cli {

void add_rows_option(Command& command, RowsOption& option, const std::string& help) {
  const std::string columns = fmt::format("{}", fmt::join(option.columns, ","));
  command.add({.names = option.single_name, .value = columns, .help = help, .take = into(option.single)});
  command.add({.names = option.file_name,
               .value = "FILE.csv",
               .help = fmt::format("A CSV file with the columns {}; - is standard input", columns),
               .take = into(option.file),
               .completes = Completes::files});
}

Rows::Rows(const RowsOption& option, const SceneOptions& scene)
    : option_(option), progress_(option.file_name.substr(2), scene.progress()) {
  if (option.single.empty() == option.file.empty()) {
    throw UsageError(fmt::format("exactly one of {} and {} is needed", option.single_name, option.file_name));
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

bool Rows::next(NumberRow& row) {
  if (file_) {
    progress_.update(file_->share_read());
    return file_->next(row);
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
