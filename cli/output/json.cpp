// SPDX-License-Identifier: MIT
#include "cli/output/json.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "csg/base/number_text.h"

namespace csgcast::cli {
namespace {

/// The length of the well-formed UTF-8 sequence that the text starts with; 0 if there is none. RFC 3629: no overlong
/// forms, no surrogates.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto follows = [&](std::size_t i, unsigned low = 0x80, unsigned high = 0xbf) {
    return byte(i) >= low && byte(i) <= high;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead <= 0xdf) return follows(1) ? 2 : 0;
  if (lead >= 0xe0 && lead <= 0xef) {
    return follows(1, lead == 0xe0 ? 0xa0 : 0x80, lead == 0xed ? 0x9f : 0xbf) && follows(2) ? 3 : 0;
  }
  if (lead >= 0xf0 && lead <= 0xf4) {
    return follows(1, lead == 0xf0 ? 0x90 : 0x80, lead == 0xf4 ? 0x8f : 0xbf) && follows(2) && follows(3) ? 4 : 0;
  }
  return 0;
}

}  // namespace

Json& Json::key(std::string_view name) {
  separate();
  append_string(name);
  out_ += ": ";
  after_key_ = true;
  return *this;
}

Json& Json::null() {
  separate();
  out_ += "null";
  return *this;
}

Json& Json::value(bool truth) {
  separate();
  out_ += truth ? "true" : "false";
  return *this;
}

Json& Json::value(double number) {
  if (!std::isfinite(number)) return null();
  separate();
  append_number(out_, number);
  return *this;
}

Json& Json::value(std::uint64_t count) {
  separate();
  fmt::format_to(std::back_inserter(out_), "{}", count);
  return *this;
}

Json& Json::value(std::string_view text) {
  separate();
  append_string(text);
  return *this;
}

Json& Json::triple(double x, double y, double z) {
  return begin_array(Layout::compact).value(x).value(y).value(z).end_array();
}

Json& Json::begin(char bracket, Layout layout) {
  separate();
  out_ += bracket;
  // What stands in a compact container is compact itself.
  const bool inherits = !levels_.empty() && levels_.back().layout == Layout::compact;
  levels_.push_back({inherits ? Layout::compact : layout});
  return *this;
}

Json& Json::end(char bracket) {
  const Level level = levels_.back();
  levels_.pop_back();
  if (level.layout == Layout::spread && !level.empty) new_line();
  out_ += bracket;
  return *this;
}

void Json::separate() {
  if (after_key_ || levels_.empty()) {
    after_key_ = false;
    return;
  }
  Level& level = levels_.back();
  if (!level.empty) out_ += level.layout == Layout::spread ? "," : ", ";
  level.empty = false;
  if (level.layout == Layout::spread) new_line();
}

void Json::new_line() {
  out_ += '\n';
  out_.append(2 * levels_.size(), ' ');
}

void Json::append_string(std::string_view text) {
  out_ += '"';
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const char first = text[0];
    if (length == 0) {
      out_ += "\\ufffd";
    } else if (first == '"' || first == '\\') {
      out_ += '\\';
      out_ += first;
    } else if (static_cast<unsigned char>(first) < 0x20) {
      fmt::format_to(std::back_inserter(out_), "\\u{:04x}", static_cast<unsigned>(first));
    } else {
      out_ += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  out_ += '"';
}

}  // namespace csgcast::cli
