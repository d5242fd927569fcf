// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "raycast/scene/scene.h"

namespace csgcast::verify {

// Special places of surfaces, as near as doubles come to them: where rays are hard. Nothing is decided by these.

/// A point where one to three surfaces meet, by Newton's method from `start`: exact residuals, the least step. Its
/// coordinates are within a few ulps of a point of all of them where they cross at an angle, and exact where they are
/// axis-parallel planes at representable places. None if the method does not settle, or the surfaces are tangent.
std::optional<Point> meeting_point(const Scene& scene, std::span<const SurfaceId> surfaces, Point start);

/// Where a quadric's gradient vanishes: the apex of a cone, the center of an ellipsoid or hyperboloid, exact where it
/// is representable. None for planes, cylinders and paraboloids, which have no such point or a whole line of them.
std::optional<Point> center_of(const Scene& scene, SurfaceId surface);

/// The directions of straight lines that lie in a quadric and pass through one of its points: two on a hyperboloid of
/// one sheet, one on a cylinder or a cone, else none. None at an apex. Coordinates that can only be rounding are 0.
std::vector<Vector> straight_lines(const Scene& scene, SurfaceId surface, Point on_it);

/// Square to the surface at a point, of unit length; zero at an apex.
Vector normal_at(const Scene& scene, SurfaceId surface, Point p);

}  // namespace csgcast::verify
