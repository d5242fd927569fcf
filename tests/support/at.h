// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "csg/solid/primitives.h"
#include "csg/solid/solid.h"

namespace csgcast::test {

inline Solid at(Solid solid, Vector offset) { return transformed(std::move(solid), translation(offset)); }

inline Solid ball(Vector center, double radius) { return at(sphere(radius), center); }

}  // namespace csgcast::test
