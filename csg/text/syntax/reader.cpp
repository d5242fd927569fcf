// SPDX-License-Identifier: MIT
#include "csg/text/syntax/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <utility>

#include "csg/text/syntax/detail/parser.h"

namespace csgcast::text {
namespace {

// All of a stream, up to the first block with a zero byte: what holds one is no text, and may have no end.
std::string contents(std::istream& stream) {
  std::string text;
  std::array<char, 1 << 16> block;
  while (stream.read(block.data(), block.size()), stream.gcount() > 0) {
    const std::string_view read(block.data(), static_cast<std::size_t>(stream.gcount()));
    text += read;
    if (read.find('\0') != std::string_view::npos) break;
  }
  return text;
}

[[noreturn]] void cannot_read(const std::string& path, const std::string& why) {
  throw Error(ErrorCode::input_output, {path, 0, 0}, "cannot read this file", why, "give the path of a scene text");
}

std::string load(const std::string& path) {
  if (path == "-") return contents(std::cin);
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) cannot_read(path, "it is a directory");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) cannot_read(path, std::strerror(errno));
  std::string text = contents(stream);
  if (stream.bad()) cannot_read(path, std::strerror(errno));
  return text;
}

Place place_at(std::string_view text, std::size_t position, const std::string& file) {
  const std::string_view before = text.substr(0, position);
  const std::size_t lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t line_start = before.rfind('\n') + 1;  // 0 on the first line: npos + 1
  return {file, static_cast<int>(lines + 1), static_cast<int>(position - line_start + 1)};
}

}  // namespace

Document read(std::string_view text, FileName file) {
  Document document;
  document.nodes = Parser(text, file).statements();
  document.file = std::move(file);
  return document;
}

Document read_file(const std::string& path) {
  const std::string file = path == "-" ? "<standard input>" : path;
  const std::string text = load(path);
  const std::size_t zero = text.find('\0');
  if (zero != std::string::npos) {
    throw Error(ErrorCode::input_output, place_at(text, zero, file), "this is not a text", "it holds a zero byte",
                "give a scene text");
  }
  return read(text, file);
}

}  // namespace csgcast::text
