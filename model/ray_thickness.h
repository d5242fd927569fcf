// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "query/ray_queries.h"
#include "raycast/cells/cells.h"

namespace csgcast {

/// How thick the solid is at the first face that each ray enters by, from t = 0 on: the way from there straight in,
/// against the normal, to the boundary again. 0 where a ray enters by none, infinite where nothing ends the solid.
/// Throws as RayQueries::intervals() does, and Error(usage) for a span other than that from 0 to infinity.
std::vector<double> ray_thickness(const Cells& cells, const Rays& rays, const QueryOptions& options = {});

}  // namespace csgcast
