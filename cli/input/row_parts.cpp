// SPDX-License-Identifier: MIT
#include "cli/input/row_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>

#include "cli/output/printable.h"
#include "cli/output/usage.h"
#include "csg/base/error.h"

namespace csgcast::cli {
namespace {

constexpr std::string_view csv_start = "# csgcast rows ";
constexpr std::string_view json_start = "\n], \"part\": \"csgcast rows ";
constexpr std::string_view json_end = "\"}\n";
constexpr std::string_view json_head = "{\"rays\": [";
constexpr std::string_view json_tail = "\n]}\n";
constexpr std::uint64_t longest_mark = 4096;

bool read_count(std::string_view text, std::uint64_t& count) {
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  return error == std::errc() && stop == text.data() + text.size() && !text.empty();
}

std::string text_of(const RowRange& rows, const PartLabel& label) {
  return fmt::format("{}:{}{}; {}", rows.first, rows.end, rows.is_last ? " the last" : "", label.text());
}

std::string shown(std::uint64_t first, std::uint64_t end) {
  return end - first == 1 ? fmt::format("row {}", first) : fmt::format("rows {}:{}", first, end);
}

/// A file of answers to some rows.
struct RowPart {
  std::string path;
  bool is_json = false;
  RowRange rows;
  PartLabel label;
  std::string head;
  std::uint64_t body_end = 0;  ///< where the mark begins; the body begins after the head
};

[[noreturn]] void not_a_part(const std::string& path, const std::string& why) {
  throw Error(ErrorCode::syntax, {path, 0, 0}, "this is no part that can be joined", why,
              "give files that csgcast render --tiles, or csgcast intervals --rows --format csv or json, has written");
}

bool read_mark(std::string_view mark, RowPart& part) {
  const std::string_view range = mark.substr(0, mark.find("; "));
  part.label = PartLabel::from(mark.substr(std::min(range.size() + 2, mark.size())));
  std::string_view numbers = range;
  constexpr std::string_view last = " the last";
  part.rows.is_last = numbers.ends_with(last);
  if (part.rows.is_last) numbers.remove_suffix(last.size());
  const std::size_t colon = numbers.find(':');
  return colon != std::string_view::npos && read_count(numbers.substr(0, colon), part.rows.first) &&
         read_count(numbers.substr(colon + 1), part.rows.end) && part.rows.first <= part.rows.end;
}

RowPart read_part(const std::string& path) {
  RowPart part;
  part.path = path;
  std::ifstream file = open_part(path);
  file.seekg(0, std::ios::end);
  const std::streamoff end = file.tellg();
  if (end < 0) not_a_part(path, "it is no regular file");
  const auto size = static_cast<std::uint64_t>(end);
  std::string start(std::min<std::uint64_t>(size, longest_mark), '\0');
  file.seekg(0);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  part.is_json = start.starts_with(json_head);
  part.head = part.is_json ? std::string(json_head) : start.substr(0, start.find('\n') + 1);
  const std::uint64_t tail_at = size - std::min(size, longest_mark);
  std::string tail(size - tail_at, '\0');
  file.seekg(static_cast<std::streamoff>(tail_at));
  file.read(tail.data(), static_cast<std::streamsize>(tail.size()));
  if (!file) not_a_part(path, "it cannot be read to its end");
  const std::string_view mark_start = part.is_json ? json_start : csv_start;
  const std::string_view mark_end = part.is_json ? json_end : std::string_view("\n");
  const std::size_t at = tail.rfind(mark_start);
  if (at == std::string::npos || !tail.ends_with(mark_end)) not_a_part(path, "the mark at its end is missing");
  const std::string_view mark = std::string_view(tail).substr(at + mark_start.size());
  part.body_end = tail_at + at;
  if (!read_mark(mark.substr(0, mark.size() - mark_end.size()), part) || part.body_end < part.head.size())
    not_a_part(path, "the mark at its end makes no sense");
  return part;
}

/// Throws Error(usage) unless each row of one result is there once.
void check_complete(const std::vector<RowPart>& parts) {
  const auto fail = [](const std::string& path, const std::string& problem, const std::string& why) {
    throw Error(ErrorCode::usage, {path, 0, 0}, problem, why, "give each row once, from the first to the last");
  };
  std::uint64_t next = 0;
  for (const RowPart& part : parts) {
    const RowPart& first = parts.front();
    if (part.is_json != first.is_json || part.head != first.head)
      fail(part.path, fmt::format("this part and {} are not of one result", first.path), "their formats differ");
    check_alike(part.path, part.label, first.path, first.label);
    if (part.rows.first > next) fail({}, shown(next, part.rows.first) + " missing", "no part has them");
    if (part.rows.first < next)
      fail(part.path, shown(part.rows.first, std::min(next, part.rows.end)) + " given twice", "another part has them");
    next = part.rows.end;
  }
  if (!parts.back().rows.is_last) fail({}, fmt::format("rows {}: missing", next), "the file goes on after them");
}

/// Copies [from, to) of a file.
void copy_body(const RowPart& part, std::uint64_t from, Output& output) {
  std::ifstream file = open_part(part.path);
  file.seekg(static_cast<std::streamoff>(from));
  std::string buffer(std::size_t{1} << 16, '\0');
  for (std::uint64_t left = part.body_end - from; left > 0;) {
    const std::uint64_t count = std::min<std::uint64_t>(left, buffer.size());
    if (!file.read(buffer.data(), static_cast<std::streamsize>(count))) not_a_part(part.path, "it became shorter");
    output.write(std::string_view(buffer).substr(0, count));
    left -= count;
  }
}

}  // namespace

RowRange parse_rows(const std::string& option, const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos)
    throw UsageError(fmt::format("{}: {} has no ':'; rows a to b - 1 are a:b", option, in_quotes(text)));
  RowRange rows;
  const std::string_view first = std::string_view(text).substr(0, colon);
  const std::string_view end = std::string_view(text).substr(colon + 1);
  if ((!first.empty() && !read_count(first, rows.first)) || (!end.empty() && !read_count(end, rows.end)))
    throw UsageError(fmt::format("{}: {} are no whole numbers from 0 on", option, in_quotes(text)));
  if (rows.first >= rows.end) throw UsageError(fmt::format("{}: {} holds no row", option, in_quotes(text)));
  return rows;
}

std::string csv_mark(const RowRange& rows, const PartLabel& label) {
  return std::string(csv_start) + text_of(rows, label) + '\n';
}

std::string json_mark(const RowRange& rows, const PartLabel& label) {
  return std::string(json_start) + text_of(rows, label) + std::string(json_end);
}

void join_rows(const std::vector<std::string>& paths, Output& output) {
  std::vector<RowPart> parts;
  parts.reserve(paths.size());
  for (const std::string& path : paths) parts.push_back(read_part(path));
  std::stable_sort(parts.begin(), parts.end(), [](const RowPart& a, const RowPart& b) {
    return a.rows.first != b.rows.first ? a.rows.first < b.rows.first : a.rows.end < b.rows.end;
  });
  check_complete(parts);
  output.write(parts.front().head);
  bool is_first = true;
  for (const RowPart& part : parts) {
    if (part.body_end == part.head.size()) continue;
    if (part.is_json && !is_first) output.write(",");
    is_first = false;
    copy_body(part, part.head.size(), output);
  }
  if (parts.front().is_json) output.write(json_tail);
}

}  // namespace csgcast::cli
