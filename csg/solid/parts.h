// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "csg/solid/solid.h"

namespace csgcast {

/// The names of a solid's parts in file order, each once. Parts count where a scene may have them: not below an
/// intersection, a difference, a complement or another part.
std::vector<std::string> part_names(const Solid& solid);

/// The first name that no part has; null if all are known.
const std::string* unknown_part(std::span<const std::string> known, std::span<const std::string> names);

/// The parts of these names, as if nothing else were there: of the unions, transforms and looks around them, what is
/// above a part that stays. Names that no part has change nothing; without any part left: empty.
Solid only_parts(const Solid& solid, std::span<const std::string> names);

}  // namespace csgcast
