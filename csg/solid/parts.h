// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "csg/solid/solid.h"

namespace csgcast {

/// The names of a solid's parts in file order, each once. A part counts only where a scene may have it: not below an
/// intersection, a difference, a complement or another part.
std::vector<std::string> part_names(const Solid& solid);

/// The first name that no part has. Null if all names are known.
const std::string* unknown_part(std::span<const std::string> known, std::span<const std::string> names);

/// The parts with these names, as if nothing else were there. Of the unions, transforms and looks around them, only
/// those above a remaining part stay. Names that no part has change nothing. The result is empty if no part is left.
Solid only_parts(const Solid& solid, std::span<const std::string> names);

}  // namespace csgcast
