// SPDX-License-Identifier: MIT
#pragma once

#include "measure/section.h"
#include "raycast/scene/scene.h"
#include "shade/film/film.h"

namespace csgcast::cli {

/// A section as a picture whose longer side has `pixels`: each pixel as dark as the share of it that is inside, by four
/// certified lines through every row, just beyond the plane.
Film section_image(const Scene& scene, const Plane& plane, const Section& section, int pixels);

}  // namespace csgcast::cli
