// SPDX-License-Identifier: MIT
#pragma once

#include "cli/output/json.h"
#include "raycast/scene/scene.h"

namespace csgcast::cli {

/// The member `quadrics`: for each surface that is one its number, kind, center, axes and sizes
/// (csg/exact/quadric_kind.h); what a kind does not have is left out, angles are in degrees.
void json_quadrics(Json& json, const Scene& scene);

}  // namespace csgcast::cli
