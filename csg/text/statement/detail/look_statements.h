// SPDX-License-Identifier: MIT
#pragma once

#include "csg/text/statement/detail/statements.h"

namespace csgcast::text {

// Looks dress the union of their children.

/// OpenSCAD's: sRGB, by name, as #rgb, #rgba, #rrggbb or #rrggbbaa, or as a list of three or four numbers; a negative
/// channel means "not set".
Combine make_color(const Call& call);
/// All of a surface; a colour by name or in hexadecimal digits is sRGB, lists are linear RGB.
Combine make_material(const Call& call);

}  // namespace csgcast::text
