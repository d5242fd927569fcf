// SPDX-License-Identifier: MIT
#pragma once

namespace csgcast::cli {

/// The values of a `--format` option.
enum class Format { table, csv, json };

}  // namespace csgcast::cli
