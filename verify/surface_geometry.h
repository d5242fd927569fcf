// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "raycast/scene/scene.h"

namespace csgcast::verify {

// These functions find special places of surfaces, where rays are hard, as exactly as doubles allow. No answer depends
// on them.

/// A point where one to three surfaces meet. It is found by Newton's method from `start`, with exact residuals and the
/// smallest step. If the surfaces cross at an angle, its coordinates are within a few ulps of a common point. If they
/// are axis-parallel planes at representable places, the coordinates are exact. Returns nothing if the method does not
/// converge, or the surfaces are tangent.
std::optional<Point> meeting_point(const Scene& scene, std::span<const SurfaceId> surfaces, Point start);

/// The point where a quadric's gradient vanishes: the apex of a cone, or the center of an ellipsoid or hyperboloid. It
/// is exact if it is representable. Returns nothing for planes, cylinders and paraboloids, which have no such point or
/// a whole line of them.
std::optional<Point> center_of(const Scene& scene, SurfaceId surface);

/// The directions of straight lines that lie in a quadric and pass through one of its points. There are two on a
/// hyperboloid of one sheet, one on a cylinder or a cone, and none otherwise or at an apex. Coordinates that can only
/// be rounding are set to 0.
std::vector<Vector> straight_lines(const Scene& scene, SurfaceId surface, Point on_it);

/// The unit normal of the surface at a point. It is zero at an apex.
Vector normal_at(const Scene& scene, SurfaceId surface, Point p);

}  // namespace csgcast::verify
