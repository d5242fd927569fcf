// SPDX-License-Identifier: MIT
#include "shade/detail/sight.h"

#include <cmath>

namespace csgcast::detail {

Sight look_along(Caster& caster, const Ray& ray) {
  caster.begin(ray);
  const std::optional<Hit> hit = caster.first_hit();
  if (!hit) return {};
  const Attribution face = caster.attribute(*hit);
  const Vector out = as_vector(face.normal);
  const double along = dot(out, ray.direction());
  const double t = hit->crossing.t;
  return {t,         face.point, along > 0 ? -out : out, std::fabs(along), hit->crossing.surface, face.leaf,
          face.part, face.look};
}

double length_inside(Caster& caster, const Ray& ray, IntervalList& scratch) {
  caster.begin(ray);
  caster.intervals(scratch);
  double sum = 0;
  for (const Interval& interval : scratch) sum += interval.exit.t - interval.entry.t;
  return sum;
}

}  // namespace csgcast::detail
