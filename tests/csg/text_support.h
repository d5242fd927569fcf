// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"

namespace csgcast::text {

inline Document read_text(std::string_view text) { return read(text, "test.csg"); }

inline SceneDescription build_text(std::string_view text, Facets facets = Facets::automatic) {
  return build(read_text(text), {facets});
}

/// The error that reading, or building what was read, throws.
inline std::optional<Error> error_of(std::string_view text, Facets facets = Facets::automatic) {
  try {
    build_text(text, facets);
  } catch (const Error& error) {
    return error;
  }
  return std::nullopt;
}

/// `unit` said `count` times.
inline std::string repeated(std::string_view unit, std::size_t count) {
  std::string result;
  result.reserve(unit.size() * count);
  for (std::size_t i = 0; i < count; ++i) result += unit;
  return result;
}

}  // namespace csgcast::text
