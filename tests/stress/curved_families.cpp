// SPDX-License-Identifier: MIT
#include <cmath>

#include "csg/solid/primitives.h"
#include "tests/stress/aimed_rays.h"
#include "tests/stress/family_lists.h"
#include "tests/stress/pieces.h"

namespace csgcast::stress {
namespace {

using test::RandomSolids;

Trial tangents(RandomSolids& random, int rays, double distance) {
  Trial trial{placed_curved(random) - placed_curved(random), {}};
  aim_at_tangents(random, trial, rays, distance);
  return trial;
}

Trial apexes(RandomSolids& random, int rays) {
  const Vector offset{random.quarter(-2, 2), random.quarter(-2, 2), random.quarter(-2, 2)};
  const Solid cone = random.index(2) == 0 ? cylinder(1, 1, 0) : quadric({1, 1, -1, 0, 0, 0}, {0, 0, 2}, -1);
  Trial trial{at(cone, offset) + at(box({1, 1, 1}), offset), {}};
  aim_at_point(random, trial, rays, Point{0, 0, 1} + offset);
  return trial;
}

// Of double cones at decimal places, turned about their axes, in scenes whose center is elsewhere: nothing is exact.
Trial rounded_apexes(RandomSolids& random, int rays) {
  const auto decimal = [&random] { return 0.05 * static_cast<double>(random.index(101)) - 2.5; };
  const Vector apex{decimal(), decimal(), decimal()};
  const Solid cone =
      transformed(hyperboloid(1.8, 0.9, 0), rotation(5 * static_cast<double>(random.index(18)), {0, 0, 1}));
  Trial trial{at(cone, apex) + at(box({12, 10, 1}), {-6.05, -4.35, -5}), {}};
  aim_at_point(random, trial, rays, Point{} + apex);
  return trial;
}

// Straight lines with exact coordinates on a quadric about the z axis, and on images of it: the line turned by a
// Pythagorean angle about the axis stays on it, up to rounding.
Trial generators(RandomSolids& random, int rays, const Solid& solid, const Ray& base) {
  constexpr Vector angles[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0.6, 0.8, 0}, {-0.28, 0.96, 0}};
  Trial trial{solid - box({0.5, 0.5, 9}), {}};
  const Vector cs = angles[random.index(5)];
  Transform turn;
  turn.entry = {cs.x, -cs.y, 0, 0, cs.y, cs.x, 0, 0, 0, 0, 1, 0};
  aim_near(random, trial, rays, moved(base, turn));
  return random.index(2) == 0 ? trial : turned(random, std::move(trial));
}

// x² + y² = r².
Trial cylinder_generators(RandomSolids& random, int rays) {
  const double r = 1 + random.quarter(0, 2);
  return generators(random, rays, cylinder(4, r, r, Centering::centered), Ray({r, 0, -3}, {0, 0, 1}));
}

// x² + y² = z², and cones that end.
Trial cone_generators(RandomSolids& random, int rays) {
  if (random.index(2) == 0) return generators(random, rays, cylinder(1, 1, 0), Ray({1, 0, 0}, {-1, 0, 1}));
  const Solid cone = quadric({1, 1, -1, 0, 0, 0}, {}, 0) & box({6, 6, 6}, Centering::centered);
  return generators(random, rays, cone, Ray({0, 0, 0}, {1, 0, 1}));
}

// x² + y² = r² + z², which has two through every point.
Trial hyperboloid_generators(RandomSolids& random, int rays) {
  const double r = 1 + random.quarter(0, 2);
  const Solid solid = quadric({1, 1, -1, 0, 0, 0}, {}, -r * r) & box({8, 8, 8}, Centering::centered);
  return generators(random, rays, solid, Ray({r, 0, 0}, {0, random.index(2) == 0 ? 1.0 : -1.0, 1}));
}

// A ball that touches the cylinder or box around it from inside.
Trial inscribed(RandomSolids& random, int rays) {
  const double r = random.quarter(0.25, 2);
  const Vector offset = random.direction();
  const Solid ball = sphere(r);
  const Solid around =
      random.index(2) == 0 ? cylinder(4, r, r, Centering::centered) : box({2 * r, 2 * r, 2 * r}, Centering::centered);
  Trial trial{at(around - ball, offset), {}};
  for (int i = 0; i < rays; ++i) {  // where they touch, and through their center
    Vector touch{};
    touch[random.index(2)] = random.index(2) == 0 ? r : -r;
    const Point p = Point{} + offset + touch;
    const Vector d = random.index(3) == 0 ? touch : random.direction();
    add(trial, p - random.number(0, 3) * d, d);
  }
  return trial;
}

// Solids about one center whose sizes are a little or far apart, in turn taken away and added.
Trial concentric(RandomSolids& random, int rays) {
  const Vector offset = random.index(2) == 0 ? Vector{} : random.direction();
  const std::size_t kind = random.index(3);
  double r = 2;
  Solid solid;
  for (int i = 0; i < 8; ++i) {
    const Solid next = kind == 0   ? sphere(r)
                       : kind == 1 ? cylinder(2 * r, r, r, Centering::centered)
                                   : ellipsoid({r, 0.5 * r, 0.25 * r});
    solid = i == 0 ? next : i % 2 == 1 ? solid - next : solid + next;
    r *= random.index(2) == 0 ? random.number(0.5, 0.95) : 1 - power_of_tenth(random, 3, 15.5);
  }
  Trial trial{at(solid, offset), {}};
  aim_at_point(random, trial, rays / 4, Point{} + offset);
  aim_at_middle(random, trial, rays / 4);
  aim_at_tangents(random, trial, rays / 4, power_of_tenth(random, 3, 15));
  return trial;
}

Trial shells(RandomSolids& random, int rays, double least, double most) {
  const double r = random.number(0.5, 2);
  const double gap = power_of_tenth(random, least, most);
  const Solid shell = random.index(2) == 0 ? sphere(r + gap) - sphere(r)
                                           : cylinder(2, r + gap, r + gap) - at(cylinder(4, r, r), {0, 0, -1});
  Trial trial{at(shell, random.direction()), {}};
  aim_at_middle(random, trial, rays);
  return trial;
}

// The same quadric made in several ways; where they are combined they must tie, as one surface.
Solid ball_by_some_route(RandomSolids& random, double r) {
  switch (random.index(5)) {
    case 0:
      return sphere(r);
    case 1:
      return transformed(sphere(4 * r), scaling({0.25, -0.25, 0.25}));
    case 2:
      return ellipsoid({r, r, r});
    case 3:
      return quadric({3, 3, 3, 0, 0, 0}, {}, -3 * r * r);
    default:
      return at(transformed(at(sphere(2 * r), {2, -1, 0.5}), scaling({-0.5, 0.5, 0.5})), {1, 0.5, -0.25});
  }
}

Trial equal_quadrics(RandomSolids& random, int rays) {
  const double r = random.quarter(0.5, 2);
  const Solid half = halfspace({1, 0, 0}, random.quarter(-0.25, 0.25));
  const Solid rest = ball_by_some_route(random, r) - (ball_by_some_route(random, r) & half);
  Trial trial{(rest + (ball_by_some_route(random, r) & ball_by_some_route(random, r) & half)) -
                  at(ball_by_some_route(random, r), {r, 0.25, 0}),
              {}};
  aim_at_grid(random, trial, rays / 3);
  aim_at_middle(random, trial, rays / 3);
  aim_at_tangents(random, trial, rays / 3, power_of_tenth(random, 6, 16));
  return trial;
}

}  // namespace

std::vector<Family> curved_families() {
  std::vector<Family> list;
  for (const int digits : {8, 10, 12, 14, 16}) {
    list.push_back({"tangent within 1e-" + std::to_string(digits), [digits](RandomSolids& random, int rays) {
                      return tangents(random, rays, std::pow(10.0, -digits));
                    }});
  }
  list.push_back({"cone apexes", apexes});
  list.push_back({"cone apexes at rounded places", rounded_apexes});
  list.push_back({"generators of cylinders", cylinder_generators});
  list.push_back({"generators of cones", cone_generators});
  list.push_back({"generators of hyperboloids", hyperboloid_generators});
  list.push_back({"inscribed", inscribed});
  list.push_back({"concentric", concentric});
  list.push_back(
      {"shells of 1e-6 to 1e-11", [](RandomSolids& random, int rays) { return shells(random, rays, 6, 11); }});
  list.push_back(
      {"shells of 1e-11 to 1e-16", [](RandomSolids& random, int rays) { return shells(random, rays, 11, 16); }});
  list.push_back({"equal quadrics by different routes", equal_quadrics});
  return list;
}

}  // namespace csgcast::stress
