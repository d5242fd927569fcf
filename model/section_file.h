// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "measure/section.h"
#include "raycast/scene/scene.h"

namespace csgcast {

/// Writes a section as the path's ending says: .svg (section_svg() within unseen_tolerance()), .json (section_json()),
/// or .png (section_image() of `pixels`). The file appears whole or not at all. `section`: of that scene at that plane.
/// Throws Error(usage) for another ending, and as those functions and WholeFile do.
void write_section(const Scene& scene, const Plane& plane, const Section& section, const std::string& path,
                   int pixels = 1024);

}  // namespace csgcast
