// SPDX-License-Identifier: MIT
#pragma once

#include "csg/base/transform.h"

namespace csgcast {

/// First `inner`, then `outer`: the matrix product. Each entry is the exact one, rounded once to the nearest double;
/// what overflows is infinite. Precondition: finite entries.
///
/// The errors of the product bound what its factors' numbers may be off. transformed(transformed(solid, inner), outer)
/// rounds nothing, and welding knows each entry of both: products are for where one matrix is wanted.
Transform operator*(const Transform& outer, const Transform& inner);

}  // namespace csgcast
