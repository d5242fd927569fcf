// SPDX-License-Identifier: MIT
#include <cmath>

#include "csg/solid/primitives.h"
#include "tests/stress/aimed_rays.h"
#include "tests/stress/family_lists.h"
#include "tests/stress/pieces.h"

namespace csgcast::stress {
namespace {

using test::RandomSolids;

// A small trial with a bit of everything: flat and curved, ties and tangents.
Trial mixed(RandomSolids& random, int rays) {
  if (random.index(2) == 0) {
    Trial trial{grid_boxes(random, 4).solid, {}};
    aim_at_grid(random, trial, rays);
    return trial;
  }
  Trial trial{placed_curved(random) - random.grid_box(), {}};
  aim_at_tangents(random, trial, rays / 2, power_of_tenth(random, 4, 15));
  aim_at_middle(random, trial, rays - rays / 2);
  return trial;
}

Trial far_away(RandomSolids& random, int rays, double least, double most) {
  const Vector offset = 1 / power_of_tenth(random, least, most) * random.direction();
  Trial trial{at(random.tree(5), offset), {}};
  aim_at_middle(random, trial, rays / 2);
  aim_by_bisection(random, trial, rays / 2, Difference::surfaces);
  return trial;
}

// The same with exact numbers: boxes on the grid moved by a power of two, with rays through their corners.
Trial far_grid(RandomSolids& random, int rays) {
  Trial trial = mixed(random, rays);
  const Vector offset = std::ldexp(1.0, 10 + static_cast<int>(random.index(31))) * Vector{1, -1, 0.5};
  trial.solid = at(trial.solid, offset);
  for (Ray& ray : trial.rays) ray = Ray(ray.origin() + offset, ray.direction());
  return trial;
}

Trial far_origins(RandomSolids& random, int rays) {
  Trial trial{random.tree(5), {}};
  const double distance = 1 / power_of_tenth(random, 3, 12);
  aim_at_middle(random, trial, rays / 2, distance);
  aim_by_bisection(random, trial, rays / 2, Difference::surfaces, distance);
  return trial;
}

Trial long_and_thin(RandomSolids& random, int rays) {
  const double aspect = 1 / power_of_tenth(random, 5, 9);
  const Transform squash = scaling({1, 1 / aspect, aspect});
  Trial trial{transformed(placed_curved(random), squash), {}};
  for (int i = 0; i < rays; ++i) trial.rays.push_back(moved(aimed_ray(random, {0, 0, 0}, 1), squash));
  return trial;
}

Trial in_units(RandomSolids& random, int rays, int most) {
  const int exponent = static_cast<int>(random.index(static_cast<std::size_t>(2 * most + 1))) - most;
  return rescaled(mixed(random, rays), exponent);
}

// A part of size 0.01 that stands on `ground`, whose top is z = 0, somewhere within 1000 of the origin.
Trial small_on(RandomSolids& random, int rays, const Solid& ground) {
  const Vector place{random.quarter(-1000, 1000), random.quarter(-1000, 1000), 0};
  const double size = 0.01;
  const Solid part = random.index(2) == 0 ? box({size, size, size}) - at(cylinder(1, 0.003, 0.003), {0.005, 0.005, 0})
                                          : cylinder(size, 0.005, 0.002);
  Trial trial{ground + at(part, place), {}};
  for (int i = 0; i < rays; ++i) {
    const Point target =
        Point{} + place + 2 * size * Vector{random.number(0, 1), random.number(0, 1), random.number(0, 0.5)};
    const Vector d = random.direction();
    const double distance = random.index(2) == 0 ? 1 : 1000 * random.number(0, 1);
    switch (random.index(4)) {
      case 0:  // in the ground's face
        add(trial, Point{target.x, target.y, 0} - 2 * Vector{d.x, d.y, 0}, {d.x, d.y, 0});
        break;
      case 1:  // grazing it
        add(trial, target - Vector{d.x, d.y, 0.001 * d.z}, {d.x, d.y, power_of_tenth(random, 3, 14) * d.z});
        break;
      case 2:  // upright
        add(trial, {target.x, target.y, 1}, {0, 0, -1});
        break;
      default:
        add(trial, target - distance * d, d);
    }
  }
  return trial;
}

Trial on_a_slab(RandomSolids& random, int rays) {
  return small_on(random, rays, at(box({1e6, 1e6, 1e6}), {-5e5, -5e5, -1e6}));
}

Trial on_a_half_space(RandomSolids& random, int rays) { return small_on(random, rays, halfspace({0, 0, 1}, 0)); }

Trial scaled_directions(RandomSolids& random, int rays) {
  Trial trial = mixed(random, rays);
  for (Ray& ray : trial.rays) {
    const int exponent = static_cast<int>(random.index(601)) - 300;
    const double factor = random.index(2) == 0 ? 1 : random.number(0.1, 10);
    ray = Ray(ray.origin(), std::ldexp(factor, exponent) * ray.direction());
  }
  return trial;
}

}  // namespace

std::vector<Family> scale_families() {
  const auto far = [](double least, double most) {
    return [=](RandomSolids& random, int rays) { return far_away(random, rays, least, most); };
  };
  const auto units = [](int most) {
    return [=](RandomSolids& random, int rays) { return in_units(random, rays, most); };
  };
  return {{"1e3 to 1e6 from the origin", far(3, 6)},
          {"1e6 to 1e9 from the origin", far(6, 9)},
          {"1e9 to 1e12 from the origin", far(9, 12)},
          {"2^10 to 2^40 from the origin", far_grid},
          {"rays from 1e3 to 1e12 sizes away", far_origins},
          {"aspect up to 1e9", long_and_thin},
          {"units of 2^-60 to 2^60", units(60)},
          {"units of 2^-350 to 2^350", units(350)},
          {"a part of 1e-2 on a slab of 1e6", on_a_slab},
          {"a part of 1e-2 on a half-space", on_a_half_space},
          {"directions of 2^-300 to 2^300", scaled_directions}};
}

}  // namespace csgcast::stress
