// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "csg/base/ids.h"
#include "csg/base/progress.h"
#include "csg/base/vector.h"
#include "measure/sheet/measures.h"
#include "raycast/scene/scene.h"

namespace csgcast {

/// The plane normal . p = distance; the normal need not be unit.
struct Plane {
  Vector normal;
  double distance = 0;
};

/// A place in a section's plane, in the scene's unit of length along its two directions.
struct PlanePoint {
  double u = 0;
  double v = 0;
};

/// A run of a conic, the inside on its left.
struct SectionArc {
  /// conic[0] u² + conic[1] uv + conic[2] v² + conic[3] u + conic[4] v + conic[5] = 0, each rounded; a straight line if
  /// the first three are 0.
  std::array<double, 6> conic{};
  PlanePoint from;
  PlanePoint middle;  ///< somewhere between, on the conic
  PlanePoint to;
  SurfaceId surface;

  bool is_straight() const { return conic[0] == 0 && conic[1] == 0 && conic[2] == 0; }
};

/// Arcs that follow each other, the last one the first: around what is inside anticlockwise, around holes clockwise, as
/// seen from where the normal points.
using SectionLoop = std::vector<SectionArc>;

/// What a plane cuts out of a solid. Where a face lies in the plane, up to rounding, it is the section just beyond, on
/// the side that the normal points to.
struct Section {
  bool is_bounded = true;
  Point origin{};  ///< of u and v: the place of the plane nearest to the scene's origin
  Vector u{};  ///< unit, square to v and to the normal, right-handed with them: horizontal if the normal is not upright
  Vector v{};  ///< unit; upwards along z as far as that goes, or along y if the normal is upright
  Measured area;
  Measured perimeter;
  std::vector<SectionLoop> loops;
  /// The ends of arcs are nearer than this to where they should be; 0 if there are none.
  double place_error = 0;
  bool is_closed = true;  ///< false: some arcs have no neighbour, as the curves come too close to tell
};

struct SectionOptions {
  double relative_error = 1e-6;  ///< of area and perimeter
  std::size_t most_pieces = 400'000;
  ProgressCallback progress{};
};

/// Throws Error(bad_value) for a normal that is zero or numbers that are not finite; Cancelled.
Section section(const Scene& scene, const Plane& plane, const SectionOptions& options = {});

/// What everybody asks who draws a section: throws Error(usage) for one of a solid that may be unbounded, which has no
/// arcs.
void require_bounded(const Section& section);

}  // namespace csgcast
