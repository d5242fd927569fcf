// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "csg/solid.h"

namespace csgcast::test {

inline Solid at(Solid solid, Vector offset) { return transformed(std::move(solid), translation(offset)); }

}  // namespace csgcast::test
