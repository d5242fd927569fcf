// SPDX-License-Identifier: MIT
#include "cli/input/tile_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <fstream>
#include <optional>

#include "csg/base/error.h"

namespace csgcast::cli {
namespace {

constexpr std::string_view magic = "csgcast tile 1";
constexpr std::string_view ending = ".csgtile";
constexpr int longest_side = 65536;
constexpr std::int64_t most_pixels = std::int64_t{1} << 27;

struct ContentWord {
  FilmContent content;
  const char* word;
};
constexpr std::array<ContentWord, 5> content_words{{{FilmContent::color, "color"},
                                                    {FilmContent::normal, "normal"},
                                                    {FilmContent::depth, "depth"},
                                                    {FilmContent::length, "length"},
                                                    {FilmContent::id, "id"}}};

const char* word(FilmContent content) {
  return std::find_if(content_words.begin(), content_words.end(), [&](const auto& w) { return w.content == content; })
      ->word;
}

std::string text_of(const TileHead& head) {
  const PixelRegion& r = head.region;
  std::string text = fmt::format("{}\ntile {} {}\npicture {} {}\nregion {} {} {} {}\ncontent {}\n", magic, head.index,
                                 head.count, head.width, head.height, r.x0, r.y0, r.x1, r.y1, word(head.content));
  for (const auto& [name, value] : head.label.entries()) text += name + ' ' + value + '\n';
  return text + "end\n";
}

/// The numbers of a value, if it is as many.
template <std::size_t count>
bool read_numbers(std::string_view text, const std::array<int*, count>& numbers) {
  const char* at = text.data();
  const char* end = at + text.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 && (at == end || *at++ != ' ')) return false;
    const auto [stop, error] = std::from_chars(at, end, *numbers[i]);
    if (error != std::errc()) return false;
    at = stop;
  }
  return at == end;
}

bool read_entry(TileHead& head, const std::string& name, const std::string& value) {
  if (name == "tile") return read_numbers<2>(value, {&head.index, &head.count});
  if (name == "picture") return read_numbers<2>(value, {&head.width, &head.height});
  if (name == "region") {
    PixelRegion& r = head.region;
    return read_numbers<4>(value, {&r.x0, &r.y0, &r.x1, &r.y1});
  }
  if (name == "content") {
    const auto found =
        std::find_if(content_words.begin(), content_words.end(), [&](auto& w) { return value == w.word; });
    if (found == content_words.end()) return false;
    head.content = found->content;
    return true;
  }
  head.label.add(name, value);
  return true;
}

bool is_possible(const TileHead& head) {
  const PixelRegion& r = head.region;
  return head.width > 0 && head.height > 0 && head.width <= longest_side && head.height <= longest_side &&
         std::int64_t{head.width} * head.height <= most_pixels && head.count > 0 && head.count <= head.height &&
         head.index >= 0 && head.index < head.count &&
         r == band_of_picture(head.width, head.height, head.index, head.count);
}

[[noreturn]] void not_a_tile(const std::string& path, const std::string& why) {
  throw Error(ErrorCode::syntax, {path, 0, 0}, "this is no whole tile of csgcast", why,
              "give files that csgcast render --tiles has written");
}

TileHead read_head(std::ifstream& file, const std::string& path) {
  constexpr int most_lines = 64;
  constexpr std::size_t longest_line = 1024;
  std::array<char, longest_line> buffer{};
  const auto next = [&]() -> std::optional<std::string> {
    file.getline(buffer.data(), buffer.size());
    return file.good() ? std::optional<std::string>(buffer.data()) : std::nullopt;
  };
  if (next() != magic) not_a_tile(path, "it does not begin like one");
  TileHead head;
  for (int i = 0; i < most_lines; ++i) {
    const std::optional<std::string> line = next();
    if (!line) break;
    if (*line == "end") {
      if (!is_possible(head)) not_a_tile(path, "its head tells of a tile that cannot be");
      return head;
    }
    const std::size_t blank = std::min(line->find(' '), line->size());
    const std::string value = line->substr(std::min(blank + 1, line->size()));
    if (!read_entry(head, line->substr(0, blank), value)) not_a_tile(path, "a line of its head makes no sense");
  }
  not_a_tile(path, "its head does not end");
}

void read_rows(std::ifstream& file, const std::string& path, const TileHead& head, Film& film) {
  const int in_a_row = head.width * channels(head.content);
  std::vector<unsigned char> bytes(4 * static_cast<std::size_t>(in_a_row));
  for (int y = head.region.y0; y < head.region.y1; ++y) {
    if (!file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())))
      not_a_tile(path, "it ends too early");
    for (int i = 0; i < in_a_row; ++i) {
      const unsigned char* b = &bytes[4 * static_cast<std::size_t>(i)];
      const std::uint32_t bits =
          b[0] | std::uint32_t{b[1]} << 8 | std::uint32_t{b[2]} << 16 | std::uint32_t{b[3]} << 24;
      film.value(i / channels(head.content), y, i % channels(head.content)) = std::bit_cast<float>(bits);
    }
  }
  if (file.peek() != std::ifstream::traits_type::eof()) not_a_tile(path, "it goes on after its last row");
}

}  // namespace

void check_tile_path(const std::string& path) {
  if (path.ends_with(ending)) return;
  throw Error(ErrorCode::usage, {path, 0, 0}, "not the name of a tile", "with --tiles a part of a picture is written",
              "let it end in .csgtile; csgcast join makes the picture");
}

void write_tile(const TileHead& head, const Film& film, Output& output) {
  output.write(text_of(head));
  std::string bytes;
  const auto flush_at = std::size_t{1} << 16;
  for (const float number : film.values()) {
    const auto bits = std::bit_cast<std::uint32_t>(number);
    for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((bits >> shift) & 0xffu);
    if (bytes.size() < flush_at) continue;
    output.write(bytes);
    bytes.clear();
  }
  output.write(bytes);
}

bool is_tile(const std::string& path) {
  std::ifstream file = open_part(path);
  std::array<char, magic.size()> start{};
  file.read(start.data(), start.size());
  return file.good() && std::string_view(start.data(), start.size()) == magic;
}

JoinedPicture join_tiles(const std::vector<std::string>& paths) {
  std::optional<Film> film;
  TileHead first;
  std::vector<const std::string*> given;
  for (const std::string& path : paths) {
    std::ifstream file = open_part(path);
    const TileHead head = read_head(file, path);
    if (!film) {
      first = head;
      film.emplace(head.width, head.height, head.content);
      given.resize(static_cast<std::size_t>(head.count));
    }
    check_alike(path, head.label, paths.front(), first.label);
    if (head.width != first.width || head.height != first.height || head.count != first.count ||
        head.content != first.content) {
      throw Error(ErrorCode::usage, {path, 0, 0}, fmt::format("this part and {} are not of one result", paths.front()),
                  "their pictures are cut in other ways", "make all parts with the same --size and number of --tiles");
    }
    const std::string*& same = given[static_cast<std::size_t>(head.index)];
    if (same != nullptr) {
      throw Error(ErrorCode::usage, {path, 0, 0}, fmt::format("tile {}/{} is given twice", head.index, head.count),
                  "it is in " + *same + ", too", "give each tile once");
    }
    same = &path;
    read_rows(file, path, head, *film);
  }
  const auto missing = std::find(given.begin(), given.end(), nullptr);
  if (missing != given.end()) {
    throw Error(ErrorCode::usage, {}, fmt::format("tile {}/{} is missing", missing - given.begin(), given.size()),
                fmt::format("{} of {} tiles are given", paths.size(), given.size()),
                "make it with csgcast render --tiles, and give all");
  }
  JoinedPicture joined{std::move(*film), {}};
  constexpr std::string_view mark = "note-";
  for (const auto& [name, value] : first.label.entries()) {
    if (name.starts_with(mark)) joined.notes.emplace_back(name.substr(mark.size()), value);
  }
  return joined;
}

}  // namespace csgcast::cli
