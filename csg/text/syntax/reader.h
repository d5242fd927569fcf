// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "csg/text/syntax/syntax.h"

namespace csgcast::text {

/// The syntax tree of a scene text (UTF-8). `file` is the name that errors show. Throws Error(syntax) at the first
/// character that does not fit, Error(bad_value) for a number beyond the range of double, Error(limit) for a list
/// nested deeper than 1,000 or with more than 4,194,304 entries and for a statement with more than 1,000 arguments.
/// What is never closed is reported where it was opened. Statements may nest to any depth. A UTF-8 byte order mark may
/// head the text. Linear in the text's length.
Document read(std::string_view text, FileName file);

/// The same for a file; "-" reads standard input. Throws Error(input_output) if it cannot be read, or is not text (a
/// zero byte).
Document read_file(const std::string& path);

}  // namespace csgcast::text
