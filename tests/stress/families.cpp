// SPDX-License-Identifier: MIT
#include "tests/stress/families.h"

#include <cmath>

#include "csg/primitives.h"
#include "tests/stress/aimed_rays.h"

namespace csgcast::stress {
namespace {

using test::RandomSolids;

Solid at(Solid solid, Vector offset) { return transformed(std::move(solid), translation(offset)); }

Transform random_rotation(RandomSolids& random) {
  return rotation(Vector{random.number(0, 360), random.number(0, 360), random.number(0, 360)});
}

// A curved leaf of each kind, moved if asked for.
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

Trial tangents(RandomSolids& random, int rays, double distance) {
  Trial trial{placed_curved(random) - placed_curved(random), {}};
  aim_at_tangents(random, trial, rays, distance);
  return trial;
}

Trial grid_specials(RandomSolids& random, int rays) {
  Trial trial{random.tree(6, [&] { return random.grid_box(); }), {}};
  aim_at_grid(random, trial, rays);
  return trial;
}

Trial turned_grid(RandomSolids& random, int rays) {
  Trial trial = grid_specials(random, rays);
  const Transform turn = random_rotation(random);
  trial.solid = transformed(trial.solid, turn);
  for (Ray& ray : trial.rays) ray = moved(ray, turn);
  return trial;
}

Trial apexes(RandomSolids& random, int rays) {
  const Vector offset{random.quarter(-2, 2), random.quarter(-2, 2), random.quarter(-2, 2)};
  const Solid cone = random.index(2) == 0 ? cylinder(1, 1, 0) : quadric({1, 1, -1, 0, 0, 0}, {0, 0, 2}, -1);
  Trial trial{at(cone, offset) + at(box({1, 1, 1}), offset), {}};
  aim_at_point(random, trial, rays, Point{0, 0, 1} + offset);
  return trial;
}

Trial generators(RandomSolids& random, int rays) {
  const double r = 1 + random.quarter(0, 2);
  const std::size_t kind = random.index(3);
  // Generators with exact coordinates: of the cylinder x² + y² = r², the cone x² + y² = z², the hyperboloid x² + y² =
  // r² + z².
  const Solid solid = kind == 0   ? cylinder(4, r, r, Centering::centered)
                      : kind == 1 ? quadric({1, 1, -1, 0, 0, 0}, {}, 0) & box({6, 6, 6}, Centering::centered)
                                  : quadric({1, 1, -1, 0, 0, 0}, {}, -r * r) & box({8, 8, 8}, Centering::centered);
  Trial trial{solid - box({0.5, 0.5, 9}), {}};
  const Ray base = kind == 0   ? Ray({r, 0, -3}, {0, 0, 1})
                   : kind == 1 ? Ray({0, 0, 0}, {0.6, 0.8, 1})
                               : Ray({r, 0, 0}, {0, 1, 1});
  aim_near(random, trial, rays, base);
  return trial;
}

Trial inscribed(RandomSolids& random, int rays) {
  const double r = random.quarter(0.25, 2);
  const Vector offset = random.direction();
  const Solid ball = sphere(r);
  const Solid around =
      random.index(2) == 0 ? cylinder(4, r, r, Centering::centered) : box({2 * r, 2 * r, 2 * r}, Centering::centered);
  Trial trial{at(around - ball, offset), {}};
  // Where they touch, and through their centre.
  for (int i = 0; i < rays; ++i) {
    Vector touch{};
    touch[random.index(2)] = random.index(2) == 0 ? r : -r;
    const Point p = Point{} + offset + touch;
    const Vector d = random.index(3) == 0 ? touch : random.direction();
    trial.rays.emplace_back(p - random.number(0, 3) * d, d);
  }
  return trial;
}

Trial shells(RandomSolids& random, int rays) {
  const double r = random.number(0.5, 2);
  const double gap = std::pow(10.0, -random.number(6, 16));
  const Solid shell = random.index(2) == 0 ? sphere(r + gap) - sphere(r)
                                           : cylinder(2, r + gap, r + gap) - at(cylinder(4, r, r), {0, 0, -1});
  Trial trial{at(shell, random.direction()), {}};
  aim_at_middle(random, trial, rays);
  return trial;
}

Trial plates(RandomSolids& random, int rays) {
  const double thickness = std::pow(10.0, -random.number(6, 16));
  Trial trial{at(box({2, 2, thickness}), random.direction()), {}};
  aim_at_middle(random, trial, rays);
  return trial;
}

Trial far_away(RandomSolids& random, int rays) {
  const double distance = std::pow(10.0, random.number(3, 12));
  const Vector offset = distance * random.direction();
  Trial trial{at(random.tree(5), offset), {}};
  aim_at_middle(random, trial, rays);
  return trial;
}

Trial far_origins(RandomSolids& random, int rays) {
  Trial trial{random.tree(5), {}};
  aim_at_middle(random, trial, rays, std::pow(10.0, random.number(3, 12)));
  return trial;
}

Trial long_and_thin(RandomSolids& random, int rays) {
  const double aspect = std::pow(10.0, random.number(5, 9));
  const Transform squash = scaling({1, 1 / aspect, aspect});
  Trial trial{transformed(placed_curved(random), squash), {}};
  for (int i = 0; i < rays; ++i) trial.rays.push_back(moved(aimed_ray(random, {0, 0, 0}, 1), squash));
  return trial;
}

// Directions on the asymptotic cone, where a vanishes or nearly does.
Trial nearly_parabolic(RandomSolids& random, int rays) {
  const double turn = random.number(0, 360);
  const Solid solid = random.index(2) == 0 ? hyperboloid(4, std::sqrt(5.0), 1) : paraboloid(2, 1) - cylinder(9, 1, 0);
  Trial trial{transformed(solid, rotation(Vector{0, 0, turn})), {}};
  for (int i = 0; i < rays; ++i) {
    const double angle = random.number(0, 6.3);
    const double off = random.index(2) == 0 ? 0 : std::pow(10.0, -random.number(6, 17));
    const Vector d = random.index(2) == 0 ? Vector{std::cos(angle), std::sin(angle), 1 + off} : Vector{off, off, 1};
    trial.rays.emplace_back(random.point(1.5) - 2 * d, d);
  }
  return trial;
}

Trial bisected(RandomSolids& random, int rays) {
  Trial trial{random.tree(3), {}};
  aim_by_bisection(random, trial, rays);
  return trial;
}

Trial nearly_equal(RandomSolids& random, int rays) {
  Solid solid = sphere(1);
  for (int i = 0; i < 12; ++i) {
    const double off = std::pow(10.0, -random.number(10, 17));
    const Solid next = at(sphere(1 + off), off * random.direction());
    solid = i % 3 == 0 ? solid + next : i % 3 == 1 ? solid - next : next - solid;
  }
  Trial trial{solid, {}};
  aim_at_middle(random, trial, rays);
  return trial;
}

Trial random_placements(RandomSolids& random, int rays) {
  Trial trial{random.tree(9), {}};
  aim_at_middle(random, trial, rays);
  return trial;
}

std::vector<Family> make_families() {
  std::vector<Family> list;
  for (const int digits : {8, 10, 12, 14, 16}) {
    list.push_back({"tangent within 1e-" + std::to_string(digits), [digits](RandomSolids& random, int rays) {
                      return tangents(random, rays, std::pow(10.0, -digits));
                    }});
  }
  list.push_back({"box edges, vertices and faces", grid_specials});
  list.push_back({"the same, turned", turned_grid});
  list.push_back({"cone apexes", apexes});
  list.push_back({"generators", generators});
  list.push_back({"inscribed", inscribed});
  list.push_back({"shells", shells});
  list.push_back({"plates", plates});
  list.push_back({"far from the origin", far_away});
  list.push_back({"rays from far away", far_origins});
  list.push_back({"aspect up to 1e9", long_and_thin});
  list.push_back({"nearly parabolic", nearly_parabolic});
  list.push_back({"bisected", bisected});
  list.push_back({"nearly equal solids", nearly_equal});
  list.push_back({"random placements", random_placements});
  return list;
}

}  // namespace

std::span<const Family> families() {
  static const std::vector<Family> list = make_families();
  return list;
}

}  // namespace csgcast::stress
