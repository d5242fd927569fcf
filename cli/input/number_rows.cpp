// SPDX-License-Identifier: MIT
#include "cli/input/number_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "cli/output/printable.h"
#include "csg/base/number_text.h"

namespace csgcast::cli {
namespace {

constexpr std::size_t chunk_size = 1 << 16;
constexpr std::size_t longest_line = 4096;
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

[[noreturn]] void cannot_read(const std::string& file, const std::string& why) {
  throw Error(ErrorCode::input_output, {file, 0, 0}, "cannot read this file", why, "give the path of a CSV file");
}

bool same_word(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

/// Calls use(field, column) for each field of a line: its text without quotes and blanks around it, and where that
/// starts, from 1.
template <class Use>
void for_each_field(std::string_view line, char separator, Use&& use) {
  std::size_t start = 0;
  while (true) {
    const std::size_t text = std::min(line.find_first_not_of(" \t", start), line.size());
    const bool is_quoted =
        text < line.size() && line[text] == '"' && line.find('"', text + 1) != std::string_view::npos;
    const std::size_t closed = is_quoted ? line.find('"', text + 1) : start;
    const std::size_t end = std::min(line.find(separator, closed), line.size());
    std::string_view field = trimmed(line.substr(start, end - start));
    if (is_quoted && field.size() >= 2 && field.back() == '"') field = trimmed(field.substr(1, field.size() - 2));
    const std::size_t place = field.empty() ? start : static_cast<std::size_t>(field.data() - line.data());
    use(field, static_cast<int>(place + 1));
    if (end == line.size()) return;
    start = end + 1;
  }
}

/// The separator of a file with this first line.
char separator_of(std::string_view line) {
  if (line.find(';') != std::string_view::npos) return ';';
  return line.find(',') == std::string_view::npos && line.find('\t') != std::string_view::npos ? '\t' : ',';
}

}  // namespace

void NumberRows::Close::operator()(std::FILE* file) const {
  if (file != stdin) static_cast<void>(std::fclose(file));
}

NumberRows::NumberRows(const std::string& path, std::vector<std::string> names, std::vector<std::string> header_names)
    : file_(path == "-" ? "<standard input>" : path), names_(std::move(names)), header_names_(std::move(header_names)) {
  std::error_code error;
  if (path == "-") {
    stream_.reset(stdin);
    return;
  }
  if (std::filesystem::is_directory(path, error)) cannot_read(file_, "it is a directory");
  stream_.reset(std::fopen(path.c_str(), "rb"));
  if (!stream_) cannot_read(file_, std::strerror(errno));
  if (std::filesystem::is_regular_file(path, error)) size_ = std::filesystem::file_size(path, error);
}

double NumberRows::share_read() const {
  return size_ == 0 ? 0 : std::min(1.0, static_cast<double>(read_) / static_cast<double>(size_));
}

bool NumberRows::next(NumberRow& row) {
  std::string_view line;
  if (!next_row(line)) return false;
  parse(line, row);
  row.index = row_count_++;
  return true;
}

bool NumberRows::skip() {
  std::string_view line;
  if (!next_row(line)) return false;
  ++row_count_;
  return true;
}

/// The next line that holds a row, as next_line().
bool NumberRows::next_row(std::string_view& line) {
  while (next_line(line)) {
    const std::string_view text = trimmed(line);
    if (text.empty() || text.front() == '#') continue;
    if (has_begun_) return true;
    begin(line);
    if (!is_header(line)) return true;
  }
  return false;
}

/// The next line without its end; false at the end of the file. It is valid until the next call.
bool NumberRows::next_line(std::string_view& line) {
  std::size_t end = buffer_.find('\n', position_);
  while (end == std::string::npos && buffer_.size() - position_ <= longest_line && fill()) {
    end = buffer_.find('\n', position_);
  }
  const bool ended = end != std::string::npos;
  if (!ended) end = buffer_.size();
  if (!ended && end == position_) return false;
  ++line_;
  line = std::string_view(buffer_).substr(position_, end - position_);
  position_ = ended ? end + 1 : end;
  if (line.size() > longest_line) {
    fail(ErrorCode::limit, 1, fmt::format("this line is longer than {} bytes", longest_line),
         fmt::format("it holds {} numbers at most", names_.size()));
  }
  if (line_ == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
  if (line.ends_with('\r')) line.remove_suffix(1);
  return true;
}

/// Reads on; false at the end of the file.
bool NumberRows::fill() {
  buffer_.erase(0, position_);
  position_ = 0;
  const std::size_t kept = buffer_.size();
  buffer_.resize(kept + chunk_size);
  const std::size_t got = std::fread(buffer_.data() + kept, 1, chunk_size, stream_.get());
  buffer_.resize(kept + got);
  if (got == 0 && std::ferror(stream_.get())) cannot_read(file_, std::strerror(errno));
  read_ += got;
  return got > 0;
}

/// Takes the separator and the columns from the first line.
void NumberRows::begin(std::string_view line) {
  has_begun_ = true;
  separator_ = separator_of(line);
  if (is_header(line)) return read_header(line);
  if (!header_names_.empty())
    fail(ErrorCode::bad_value, 1, "there is no header", "--columns says what its columns are called");
  for (std::size_t i = 0; i < names_.size(); ++i) column_of_.push_back(i);
}

/// A first line is a header if its first field starts like a word; a number that is not finite is no word.
bool NumberRows::is_header(std::string_view line) const {
  bool result = false, is_first = true;
  for_each_field(line, separator_, [&](std::string_view field, int) {
    if (is_first)
      result = !field.empty() && std::isalpha(static_cast<unsigned char>(field[0])) &&
               parse_number(field).fault == NumberFault::no_number;
    is_first = false;
  });
  return result;
}

void NumberRows::read_header(std::string_view line) {
  const std::vector<std::string>& wanted = header_names_.empty() ? names_ : header_names_;
  std::vector<bool> is_found(wanted.size());
  for_each_field(line, separator_, [&](std::string_view field, int column) {
    const auto found =
        std::find_if(wanted.begin(), wanted.end(), [&](const std::string& name) { return same_word(field, name); });
    if (found == wanted.end()) return column_of_.push_back(NumberRow::max_columns);
    const auto index = static_cast<std::size_t>(found - wanted.begin());
    if (is_found[index])
      fail(ErrorCode::bad_value, column, fmt::format("the header names a column {} twice", in_quotes(field)),
           "only one can be meant");
    is_found[index] = true;
    column_of_.push_back(index);
  });
  const auto missing = std::find(is_found.begin(), is_found.end(), false);
  if (missing == is_found.end()) return;
  const std::string& name = wanted[static_cast<std::size_t>(missing - is_found.begin())];
  throw Error(ErrorCode::bad_value, {file_, line_, 1}, fmt::format("the header names no column {}", in_quotes(name)),
              fmt::format("wanted are {}", fmt::join(wanted, ",")),
              "name them so, say with --columns what they are called, or leave the header out");
}

void NumberRows::parse(std::string_view line, NumberRow& row) const {
  std::size_t count = 0;
  for_each_field(line, separator_, [&](std::string_view field, int column) {
    if (count == column_of_.size()) {
      fail(ErrorCode::bad_value, column, "this line has too many numbers",
           fmt::format("there are {} columns", column_of_.size()));
    }
    const std::size_t index = column_of_[count++];
    if (index == NumberRow::max_columns) return;
    row.values[index] = parse_field(field, column);
    row.columns[index] = column;
  });
  if (count < column_of_.size()) {
    const std::size_t index = column_of_[count];
    fail(ErrorCode::bad_value, static_cast<int>(line.size() + 1), "this line has too few numbers",
         index == NumberRow::max_columns ? fmt::format("there are {} columns", column_of_.size())
                                         : fmt::format("'{}' is missing", names_[index]));
  }
  row.line = line_;
}

double NumberRows::parse_field(std::string_view field, int column) const {
  if (field.empty()) fail(ErrorCode::syntax, column, "a number is missing", "this field is empty");
  std::string with_point;
  if (separator_ == ';' && field.find('.') == std::string_view::npos && field.find(',') != std::string_view::npos) {
    with_point = field;
    std::replace(with_point.begin(), with_point.end(), ',', '.');
  }
  const ParsedNumber parsed = parse_number(with_point.empty() ? field : with_point);
  switch (parsed.fault) {
    case NumberFault::no_number:
      fail(ErrorCode::syntax, column, fmt::format("{} is no number", in_quotes(field)), "only numbers stand here");
    case NumberFault::out_of_range:
      fail(ErrorCode::bad_value, column, fmt::format("{} is too large", in_quotes(field)),
           "it is beyond the range of double");
    case NumberFault::none:
      break;
  }
  if (!std::isfinite(parsed.value)) {
    fail(ErrorCode::bad_value, column, fmt::format("{} is not finite", in_quotes(field)), "it is no place in space");
  }
  return parsed.value;
}

void NumberRows::fail(ErrorCode code, int column, const std::string& problem, const std::string& why) const {
  throw Error(code, {file_, line_, column}, problem, why, remedy());
}

std::string NumberRows::remedy() const { return fmt::format("write {} on each line", fmt::join(names_, ",")); }

}  // namespace csgcast::cli
