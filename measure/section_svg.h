// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "measure/section.h"

namespace csgcast {

struct PlaneRectangle {
  PlanePoint least;
  PlanePoint greatest;
};

/// What a picture of a section shows: all of it, with a small margin.
PlaneRectangle seen_rectangle(const Section& section);

/// A section as an SVG picture: one filled path of lines, elliptic arcs, which are exact but for the rounding of their
/// numbers, and quadratic Béziers for parabolas and hyperbolas, which are within `tolerance` of them. u goes right, v
/// up; one unit of the picture is one of the scene.
std::string section_svg(const Section& section, double tolerance);

}  // namespace csgcast
