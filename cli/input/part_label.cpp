// SPDX-License-Identifier: MIT
#include "cli/input/part_label.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <span>
#include <system_error>

#include "csg/base/error.h"
#include "csg/base/number_text.h"
#include "csg/text/syntax/each_statement.h"
#include "csg/text/syntax/writer.h"

namespace csgcast::cli {
namespace {

/// FNV-1a, 64 bits: tells mistakes, not malice. Source: Fowler, Noll, Vo 1991.
class Hash {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) add_byte(static_cast<unsigned char>(byte));
  }
  void add(int number) {
    for (unsigned shift = 0; shift < 32; shift += 8) add_byte((static_cast<std::uint32_t>(number) >> shift) & 0xffu);
  }
  std::string text() const { return fmt::format("{:016x}", value_); }

 private:
  void add_byte(std::uint32_t byte) { value_ = (value_ ^ byte) * 0x100000001b3u; }

  std::uint64_t value_ = 0xcbf29ce484222325u;
};

std::string hash_of(const text::Document& document) {
  Hash hash;
  hash.add(text::write(document));
  text::each_statement(std::span<const text::Node>(document.nodes), [&](const text::Node& node) {
    hash.add(node.line);
    hash.add(node.column);
  });
  return hash.text();
}

std::string hash_of(const std::vector<std::string>& names) {
  Hash hash;
  for (const std::string& name : names) {
    hash.add(static_cast<int>(name.size()));
    hash.add(name);
  }
  return hash.text();
}

}  // namespace

PartLabel::PartLabel(const text::Document& document, const SceneOptions& options) {
  add("scene", hash_of(document));
  add("facets", options.facets == text::Facets::always  ? "always"
                : options.facets == text::Facets::never ? "never"
                                                        : "auto");
  add("weld", options.welding.mode == Welding::Mode::derived ? "derived" : number(options.welding.tolerance));
  if (!options.parts.empty()) add("part", hash_of(options.parts));
}

std::string PartLabel::text() const {
  std::string text;
  for (const auto& [name, value] : entries_) text += (text.empty() ? "" : "; ") + name + ' ' + value;
  return text;
}

PartLabel PartLabel::from(std::string_view text) {
  PartLabel label;
  while (!text.empty()) {
    const std::string_view entry = text.substr(0, text.find("; "));
    const std::string_view name = entry.substr(0, entry.find(' '));
    label.add(std::string(name), std::string(entry.substr(std::min(name.size() + 1, entry.size()))));
    text.remove_prefix(std::min(entry.size() + 2, text.size()));
  }
  return label;
}

std::string PartLabel::difference(const PartLabel& other) const {
  const std::size_t count = std::max(entries_.size(), other.entries_.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (i >= entries_.size()) return other.entries_[i].first;
    if (i >= other.entries_.size() || entries_[i] != other.entries_[i]) return entries_[i].first;
  }
  return {};
}

std::ifstream open_part(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw Error(ErrorCode::input_output, {path, 0, 0}, "cannot read this file", std::generic_category().message(errno),
                "give the paths of parts");
  }
  return file;
}

void check_alike(const std::string& path, const PartLabel& label, const std::string& first_path,
                 const PartLabel& first) {
  const std::string difference = label.difference(first);
  if (difference.empty()) return;
  throw Error(ErrorCode::usage, {path, 0, 0}, fmt::format("this part and {} are not of one result", first_path),
              fmt::format("they were made with another '{}'", difference),
              "make all parts from the same scene with the same options");
}

}  // namespace csgcast::cli
