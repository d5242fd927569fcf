// SPDX-License-Identifier: MIT
#include "tests/stress/aimed_rays.h"

#include <cmath>

#include "csg/base/length.h"
#include "raycast/ray/caster.h"
#include "tests/stress/pieces.h"

namespace csgcast::stress {
namespace {

using test::RandomSolids;

Point image(const Transform& m, Point p) {
  Point result;
  for (std::size_t row = 0; row < 3; ++row)
    result[row] = m(row, 0) * p.x + m(row, 1) * p.y + m(row, 2) * p.z + m(row, 3);
  return result;
}

// 0, a few ulps, or up to 1e-6, relative.
Vector nudge(RandomSolids& random, Vector v) {
  const std::size_t kind = random.index(3);
  if (kind == 0) return v;
  const double most = kind == 1 ? 0x1p-51 : std::pow(10.0, -random.number(6, 15));
  const double size = length(v);
  for (std::size_t axis = 0; axis < 3; ++axis) v[axis] += most * size * random.number(-1, 1);
  return v;
}

Box target_box(const Solid& solid) {
  const Box box = bounds(solid);
  return box.is_finite() ? box : Box{{-1, -1, -1}, {1, 1, 1}};
}

Point point_in(RandomSolids& random, const Box& box) {
  const Vector size = box.size();
  return box.lower + Vector{size.x * random.number(0, 1), size.y * random.number(0, 1), size.z * random.number(0, 1)};
}

// What a ray sees, as far as the difference asks.
void look(Caster& caster, const Ray& ray, Difference difference, IntervalList& list, std::vector<SurfaceId>& seen) {
  caster.begin(ray);
  caster.intervals(list, Span::line());
  seen.clear();
  for (const Interval& interval : list) {
    const bool tell = difference == Difference::surfaces;
    seen.push_back(tell ? interval.entry.surface : SurfaceId());
    seen.push_back(tell ? interval.exit.surface : SurfaceId());
  }
}

}  // namespace

Ray aimed_ray(RandomSolids& random, Point target, double distance) {
  const Vector d = random.direction();
  return Ray(target - distance * d, d);
}

Ray moved(const Ray& ray, const Transform& transform) {
  const Point origin = image(transform, ray.origin());
  const Vector d = image(transform, ray.origin() + ray.direction()) - origin;
  return d == Vector{} ? ray : Ray(origin, d);
}

void aim_at_tangents(RandomSolids& random, Trial& trial, int rays, double distance) {
  const Scene scene = compile(trial.solid);
  Caster caster(scene);
  const Box box = target_box(trial.solid);
  for (int i = 0; i < rays; ++i) {
    const Ray probe = aimed_ray(random, point_in(random, box), 4);
    caster.begin(probe);
    const std::optional<Hit> hit = caster.first_hit();
    if (!hit) continue;
    const Vector normal = as_vector(caster.attribute(*hit).normal);
    const Vector along = normalised(cross(normal, random.direction()));
    const double off = (random.index(2) == 0 ? 1 : -1) * distance * random.number(0, 1);
    add(trial, probe.at(hit->crossing.t) + off * normal - random.number(0, 3) * along, along);
  }
}

void aim_at_grid(RandomSolids& random, Trial& trial, int rays) {
  const auto grid_point = [&] { return Point{random.quarter(-2, 2), random.quarter(-2, 2), random.quarter(-2, 2)}; };
  for (int i = 0; i < rays; ++i) {
    const Point a = grid_point();
    const Vector d = grid_point() - a;
    Vector axis;
    axis[random.index(3)] = random.index(2) == 0 ? 1 : -1;
    const std::size_t kind = random.index(4);
    add(trial, a, kind == 0 ? axis : kind == 1 ? nudge(random, d) : d);
  }
}

void aim_at_point(RandomSolids& random, Trial& trial, int rays, Point target) {
  for (int i = 0; i < rays; ++i) {
    const Vector d{random.quarter(-1, 1), random.quarter(-1, 1), random.quarter(-1, 1)};
    add(trial, target - random.quarter(0, 4) * d, nudge(random, d));
    add(trial, Point{} + nudge(random, target - Point{}), random.direction());
  }
}

void aim_near(RandomSolids& random, Trial& trial, int rays, const Ray& base) {
  for (int i = 0; i < rays; ++i) {
    const double back = random.quarter(0, 3);
    const Vector d = random.index(2) == 0 ? base.direction() : -base.direction();
    add(trial, Point{} + nudge(random, base.origin() - back * base.direction() - Point{}), nudge(random, d));
  }
}

void aim_at_middle(RandomSolids& random, Trial& trial, int rays, double distance) {
  const Box box = target_box(trial.solid);
  const double size = length(box.size());
  for (int i = 0; i < rays; ++i) {
    const Vector d = size * random.direction();
    add(trial, point_in(random, box) - distance * d, d);
  }
}

void aim_by_bisection(RandomSolids& random, Trial& trial, int rays, Difference difference, double distance) {
  const Scene scene = compile(trial.solid);
  Caster caster(scene);
  IntervalList list;
  std::vector<SurfaceId> at_a;
  std::vector<SurfaceId> seen;
  const Box box = target_box(trial.solid);
  const double size = length(box.size());
  if (!(size > 0)) return;
  for (int i = 0; i < rays; i += 8) {
    const Point eye = box.center() + distance * size * random.direction();
    Vector a = point_in(random, box) - eye;
    Vector b = point_in(random, box) - eye;
    if (a == Vector{} || b == Vector{}) continue;
    look(caster, Ray(eye, a), difference, list, at_a);
    look(caster, Ray(eye, b), difference, list, seen);
    if (seen == at_a) continue;
    for (int step = 0; step < 54; ++step) {
      const Vector middle = 0.5 * (a + b);
      if (middle == Vector{}) break;
      look(caster, Ray(eye, middle), difference, list, seen);
      (seen == at_a ? a : b) = middle;
      if (step > 45) add(trial, eye, middle);
    }
  }
}

}  // namespace csgcast::stress
