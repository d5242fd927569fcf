// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "cli/input/part_label.h"
#include "cli/output/output.h"

namespace csgcast::cli {

/// Rows [first, end) of a file, counted from 0.
struct RowRange {
  std::uint64_t first = 0;
  std::uint64_t end = std::numeric_limits<std::uint64_t>::max();
  bool is_last = false;  ///< the file ends there
};

/// `a:b`, `a:` or `:b`. Throws UsageError, naming the option.
RowRange parse_rows(const std::string& option, const std::string& text);

/// What stands behind the answers to some rows of a file, and tells which they are: for CSV a line that starts with #,
/// for JSON a member `part`. Without it the parts are whole files of their kind.
std::string csv_mark(const RowRange& rows, const PartLabel& label);
std::string json_mark(const RowRange& rows, const PartLabel& label);

/// Writes what one run over the whole file would have written. Throws Error(input_output) for a file that cannot be
/// read, Error(syntax) for one that is no part, Error(usage) if the parts are not all those of one result, each row
/// once.
void join_rows(const std::vector<std::string>& paths, Output& output);

}  // namespace csgcast::cli
