// SPDX-License-Identifier: MIT
#include "shade/trace/detail/sight.h"

#include <cmath>

namespace csgcast::detail {

Sight sight_of(double t, Point point, Vector out, Vector direction, SurfaceId surface, LeafId leaf, PartId part,
               LookId look) {
  const double along = dot(out, direction);
  return {t, point, along > 0 ? -out : out, std::fabs(along), surface, leaf, part, look};
}

Sight look_along(Caster& caster, const Ray& ray) {
  caster.begin(ray);
  const std::optional<Hit> hit = caster.first_hit({}, Rounding::close);
  if (!hit) return {};
  const Attribution face = caster.attribute(*hit);
  return sight_of(hit->crossing.t, face.point, as_vector(face.normal), ray.direction(), hit->crossing.surface,
                  face.leaf, face.part, face.look);
}

double total_length(std::span<const Interval> intervals) {
  double sum = 0;
  for (const Interval& interval : intervals) sum += interval.exit.t - interval.entry.t;
  return sum;
}

double length_inside(Caster& caster, const Ray& ray, IntervalList& scratch) {
  caster.begin(ray);
  caster.intervals(scratch);
  return total_length(scratch);
}

}  // namespace csgcast::detail
