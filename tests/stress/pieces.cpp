// SPDX-License-Identifier: MIT
#include "tests/stress/pieces.h"

#include <cmath>

#include "csg/base/length.h"
#include "csg/solid/primitives.h"
#include "tests/stress/aimed_rays.h"

namespace csgcast::stress {

using test::RandomSolids;

Transform random_rotation(RandomSolids& random) {
  return rotation(Vector{random.number(0, 360), random.number(0, 360), random.number(0, 360)});
}

double power_of_tenth(RandomSolids& random, double least, double most) {
  return std::pow(10.0, -random.number(least, most));
}

Solid curved(RandomSolids& random) {
  const double r = random.number(0.3, 2);
  switch (random.index(6)) {
    case 0:
      return sphere(r);
    case 1:
      return cylinder(2, r, r, Centering::centered);
    case 2:
      return cylinder(2, r, random.index(2) == 0 ? 0 : 0.5 * r, Centering::centered);
    case 3:
      return ellipsoid({r, random.number(0.3, 2), random.number(0.3, 2)});
    case 4:
      return paraboloid(r, random.number(0.3, 2));
    default:
      return hyperboloid(2, r + 0.5, r);
  }
}

Solid placed_curved(RandomSolids& random) {
  const Solid solid = curved(random);
  return random.index(2) == 0 ? solid : at(transformed(solid, random_rotation(random)), random.direction());
}

GridBoxes grid_boxes(RandomSolids& random, int count) {
  GridBoxes grid;
  for (int i = 0; i < count; ++i) {
    const Vector size{random.quarter(0.25, 1.5), random.quarter(0.25, 1.5), random.quarter(0.25, 1.5)};
    const Vector corner{random.quarter(-1, 1), random.quarter(-1, 1), random.quarter(-1, 1)};
    const Solid next = at(box(size), corner);
    grid.boxes.push_back({Point{} + corner, Point{} + corner + size});
    const std::size_t kind = i == 0 ? 0 : random.index(5);
    grid.solid = kind < 3 ? grid.solid + next : kind == 3 ? grid.solid - next : next - grid.solid;
  }
  return grid;
}

void add(Trial& trial, Point o, Vector d) {
  if (is_finite(o) && is_finite(d) && d != Vector{} && Ray::in_range(o, d)) trial.rays.emplace_back(o, d);
}

Trial turned(RandomSolids& random, Trial trial) {
  const Transform turn = random_rotation(random);
  trial.solid = transformed(trial.solid, turn);
  for (Ray& ray : trial.rays) ray = moved(ray, turn);
  return trial;
}

Trial rescaled(Trial trial, int exponent) {
  const double factor = std::ldexp(1.0, exponent);
  trial.solid = transformed(trial.solid, scaling({factor, factor, factor}));
  const std::vector<Ray> rays = std::move(trial.rays);
  trial.rays.clear();
  for (const Ray& ray : rays) add(trial, Point{} + factor * as_vector(ray.origin()), factor * ray.direction());
  return trial;
}

}  // namespace csgcast::stress
