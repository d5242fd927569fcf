// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/ray/caster.h"

namespace csgcast::test {

/// Whether the whole line of a ray and its reverse give mirrored lists: the same surfaces and leaves, entries for
/// exits, each t negated, bit by bit.
bool mirrors(Caster& caster, const Ray& ray);

}  // namespace csgcast::test
