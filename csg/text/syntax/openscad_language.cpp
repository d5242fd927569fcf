// SPDX-License-Identifier: MIT
#include "csg/text/syntax/openscad_language.h"

#include <algorithm>
#include <array>

namespace csgcast::text {

bool is_openscad_keyword(std::string_view word) {
  constexpr std::array<std::string_view, 15> keywords{"module", "function", "for",  "intersection_for", "if",
                                                      "else",   "let",      "each", "assert",           "echo",
                                                      "assign", "children", "use",  "include",          "child"};
  return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

}  // namespace csgcast::text
