// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "csg/base/vector.h"
#include "csg/solid/look.h"

namespace csgcast::cli {

/// Appends JSON to a string, commas and indentation included. Strings are escaped, and bytes that are not UTF-8 are
/// replaced, so the result is always valid JSON.
class Json {
 public:
  enum class Layout { spread, compact };  ///< a line for each member, or all on one

  explicit Json(std::string& out) : out_(out) {}

  Json& begin_object(Layout layout = Layout::spread) { return begin('{', layout); }
  Json& end_object() { return end('}'); }
  Json& begin_array(Layout layout = Layout::spread) { return begin('[', layout); }
  Json& end_array() { return end(']'); }

  /// The name of the next value of an object.
  Json& key(std::string_view name);

  Json& null();
  Json& value(bool truth);
  /// So that it reads back to the same double; null if it is not finite.
  Json& value(double number);
  Json& value(std::uint64_t count);
  Json& value(std::string_view text);
  Json& value(const char* text) { return value(std::string_view(text)); }

  /// `[x, y, z]`.
  Json& triple(double x, double y, double z);
  template <class Tag>
  Json& value(const Triple<Tag>& t) {
    return triple(t.x, t.y, t.z);
  }
  Json& value(const Rgb& color) { return triple(color.r, color.g, color.b); }

  template <class T>
  Json& member(std::string_view name, const T& content) {
    key(name);
    return value(content);
  }

 private:
  struct Level {
    Layout layout;
    bool empty = true;
  };

  Json& begin(char bracket, Layout layout);
  Json& end(char bracket);
  void separate();
  void new_line();
  void append_string(std::string_view text);

  std::string& out_;
  std::vector<Level> levels_;
  bool after_key_ = false;
};

}  // namespace csgcast::cli
