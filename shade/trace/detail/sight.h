// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "raycast/line/ray.h"
#include "raycast/ray/caster.h"
#include "raycast/ray/hit.h"

namespace csgcast::detail {

/// What a ray of unit direction sees first, without light. Nothing if the leaf is not valid.
struct Sight {
  double t = 0;
  Point point;
  Vector normal;      ///< unit, towards the viewer
  double facing = 0;  ///< cosine between the normal and the direction to the viewer, >= 0
  SurfaceId surface;
  LeafId leaf;
  PartId part;
  LookId look;
};

/// `out`: the face's normal out of the solid. `direction`: the ray's.
Sight sight_of(double t, Point point, Vector out, Vector direction, SurfaceId surface, LeafId leaf, PartId part,
               LookId look);

/// The first boundary of the whole solid on the ray. t: Rounding::close.
Sight look_along(Caster& caster, const Ray& ray);

/// The sum of the intervals' lengths.
double total_length(std::span<const Interval> intervals);

/// How long the ray is inside the solid; infinite if it stays there.
double length_inside(Caster& caster, const Ray& ray, IntervalList& scratch);

}  // namespace csgcast::detail
