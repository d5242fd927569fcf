// SPDX-License-Identifier: MIT
#pragma once

#include "csg/base/transform.h"

namespace csgcast {

/// First `inner`, then `outer`: the matrix product. Each entry is the exact one, rounded once to the nearest double;
/// what overflows is infinite. Precondition: finite entries.
///
/// linear_error of the product bounds what its factors' numbers may be off. Of the offset welding knows half an ulp
/// only. transformed(transformed(solid, inner), outer) rounds nothing, and welding knows all of it: products are for
/// where one matrix is wanted.
Transform operator*(const Transform& outer, const Transform& inner);

}  // namespace csgcast
