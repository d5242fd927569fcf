// SPDX-License-Identifier: MIT
#pragma once

#include "measure/section.h"
#include "raycast/scene/scene.h"
#include "shade/film/film.h"

namespace csgcast {

/// A section as a picture whose longer side has `pixels`: each pixel as dark as the share of it that is inside, by four
/// certified lines through every row, just beyond the plane. Throws Error(usage) for a section that may be unbounded,
/// and Error(limit) unless `pixels` is 1 to 16384. `section`: of that scene at that plane.
Film section_image(const Scene& scene, const Plane& plane, const Section& section, int pixels);

}  // namespace csgcast
