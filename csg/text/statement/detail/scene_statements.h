// SPDX-License-Identifier: MIT
#pragma once

#include "csg/text/statement/detail/statements.h"

namespace csgcast::text {

// What the picture needs besides the solid.

void apply_camera(const Call& call, SceneDescription& scene);
void apply_light(const Call& call, SceneDescription& scene);
void apply_background(const Call& call, SceneDescription& scene);
void apply_settings(const Call& call, SceneDescription& scene);

}  // namespace csgcast::text
