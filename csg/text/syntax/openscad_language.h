// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace csgcast::text {

/// Words that only OpenSCAD's own language gives a meaning to: `module`, `for`, `if`, ...; a scene text has none of
/// them.
bool is_openscad_keyword(std::string_view word);

/// What to do with a text in OpenSCAD's language.
inline constexpr std::string_view export_remedy = "export the scene with `openscad -o x.csg x.scad` and read x.csg";
inline constexpr std::string_view language_reason =
    "that is OpenSCAD's programming language; a scene text holds only solids and plain values";

}  // namespace csgcast::text
