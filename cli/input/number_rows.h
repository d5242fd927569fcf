// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "csg/base/error.h"

namespace csgcast::cli {

/// One row of numbers, as many as the table has columns, all finite.
struct NumberRow {
  static constexpr std::size_t max_columns = 6;

  std::uint64_t index = 0;  ///< rows counted from 0, without header and blank lines
  std::array<double, max_columns> values{};
  std::array<int, max_columns> columns{};  ///< where in the line each number starts, from 1, in bytes
  int line = 0;                            ///< 0 if it came from the command line
};

/// A CSV file of numbers, read a row at a time in bounded memory.
///
/// Fields are separated by commas, by semicolons or by tabs, whichever the first line has, with blanks around them as
/// one likes, and in double quotes or not. Between semicolons a decimal comma is a point. Lines end in LF or CR LF;
/// blank lines and those that begin with # are skipped; a UTF-8 byte order mark may head the file. The first line may
/// be a header: then it names the columns, in any order, in either case, and others, which are passed over.
class NumberRows {
 public:
  /// "-" reads standard input. `header_names` says what the header calls the columns; if there are any, there must be a
  /// header. Throws Error(input_output) if the file cannot be read. At most NumberRow::max_columns names.
  NumberRows(const std::string& path, std::vector<std::string> names, std::vector<std::string> header_names = {});

  /// The next row; false at the end. Throws Error with the place of the first thing wrong: a word for a number, a
  /// number that is not finite or beyond the range of double, too few or too many of them, a line of more than 4096
  /// bytes, a header without one of the columns or with one twice.
  bool next(NumberRow& row);
  /// Passes over the next row without looking at its numbers; false at the end.
  bool skip();
  /// How many rows were read or passed over.
  std::uint64_t count() const { return row_count_; }

  /// How much of the file has been read, in [0, 1]; 0 if its size is unknown.
  double share_read() const;
  /// The file as errors name it.
  const std::string& file() const { return file_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const;
  };

  bool next_line(std::string_view& line);
  bool next_row(std::string_view& line);
  bool fill();
  void begin(std::string_view line);
  bool is_header(std::string_view line) const;
  void read_header(std::string_view line);
  void parse(std::string_view line, NumberRow& row) const;
  double parse_field(std::string_view field, int column) const;
  [[noreturn]] void fail(ErrorCode code, int column, const std::string& problem, const std::string& why) const;
  std::string remedy() const;

  std::string file_;
  std::vector<std::string> names_;
  std::vector<std::string> header_names_;
  bool has_begun_ = false;
  char separator_ = ',';
  std::vector<std::size_t> column_of_;  // of each field of a line; NumberRow::max_columns: passed over
  std::unique_ptr<std::FILE, Close> stream_;
  std::uint64_t size_ = 0;
  std::uint64_t read_ = 0;
  std::string buffer_;  // what has been read and not yet handed out starts at position_
  std::size_t position_ = 0;
  int line_ = 0;
  std::uint64_t row_count_ = 0;
};

}  // namespace csgcast::cli
