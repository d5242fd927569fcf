// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "csg/solid/primitives.h"
#include "tests/stress/aimed_rays.h"
#include "tests/stress/family_lists.h"
#include "tests/stress/pieces.h"
#include "verify/adversarial_rays.h"

namespace csgcast::stress {
namespace {

using test::RandomSolids;

constexpr int greatest_exponent = 300;

// In [1, 2) times a power of two in [2^low, 2^high].
double scaled(RandomSolids& random, int low, int high) {
  const int exponent = low + static_cast<int>(random.index(static_cast<std::size_t>(high - low + 1)));
  return std::ldexp(random.number(1, 2), exponent);
}
double small(RandomSolids& random) { return scaled(random, -greatest_exponent, 0); }
double large(RandomSolids& random) { return scaled(random, 0, greatest_exponent); }
double signed_small(RandomSolids& random) { return (random.index(2) == 0 ? 1 : -1) * small(random); }

Solid anyhow(RandomSolids& random, const Solid& solid) {
  return random.index(4) == 0 ? solid : transformed(solid, random_rotation(random));
}

Solid somewhere(RandomSolids& random, const Solid& solid) { return at(solid, 3 * random.direction()); }

// What is `small` or far beside things of size 1.
Solid beside_ordinary(RandomSolids& random, std::vector<Solid> solids) {
  solids.push_back(random.index(2) == 0 ? sphere(1) : box({1, 1, 1}));
  return unite(std::move(solids));
}

Solid tiny(RandomSolids& random, Solid (*make)(RandomSolids&)) {
  std::vector<Solid> solids;
  for (int i = 0; i < 3; ++i) solids.push_back(somewhere(random, make(random)));
  return beside_ordinary(random, std::move(solids));
}

Solid tiny_ball(RandomSolids& random) { return anyhow(random, sphere(small(random))); }
Solid tiny_box(RandomSolids& random) {
  const double size = small(random);
  return anyhow(random, box({size, 2 * size, 3 * size}));
}
Solid tiny_cylinder(RandomSolids& random) {
  const double size = small(random);
  return anyhow(random, cylinder(size, size, random.index(2) == 0 ? size : 0));
}
Solid tiny_quadric(RandomSolids& random) {
  const double size = small(random);
  return anyhow(random, transformed(curved(random), scaling({size, size, size})));
}

Solid tiny_balls(RandomSolids& random) { return tiny(random, tiny_ball); }
Solid tiny_boxes(RandomSolids& random) { return tiny(random, tiny_box); }
Solid tiny_cylinders(RandomSolids& random) { return tiny(random, tiny_cylinder); }
Solid tiny_quadrics(RandomSolids& random) { return tiny(random, tiny_quadric); }

Solid far_solids(RandomSolids& random, Solid (*make)(RandomSolids&)) {
  std::vector<Solid> solids;
  for (int i = 0; i < 3; ++i) {
    Vector offset = random.direction();
    for (std::size_t axis = 0; axis < 3; ++axis) offset[axis] *= random.index(3) == 0 ? 1 : large(random);
    solids.push_back(at(make(random), offset));
  }
  return beside_ordinary(random, std::move(solids));
}

Solid far_balls(RandomSolids& random) {
  return far_solids(random, [](RandomSolids& r) { return sphere(r.number(0.2, 2)); });
}
Solid far_curved(RandomSolids& random) { return far_solids(random, placed_curved); }
Solid far_boxes(RandomSolids& random) {
  return far_solids(random, [](RandomSolids& r) { return anyhow(r, box({1, 2, 3})); });
}

Solid flat_paraboloid(RandomSolids& random) { return anyhow(random, paraboloid(small(random), 2)); }
Solid steep_paraboloid(RandomSolids& random) { return anyhow(random, paraboloid(large(random), 2)); }
Solid flat_hyperboloid(RandomSolids& random) { return anyhow(random, hyperboloid(small(random), 2, small(random))); }
Solid tall_hyperboloid(RandomSolids& random) { return anyhow(random, hyperboloid(large(random), 2, small(random))); }
Solid needle(RandomSolids& random) {
  const double r = small(random);
  return anyhow(random, cylinder(10, r, r));
}
Solid thin_cone(RandomSolids& random) {
  return anyhow(random, cylinder(10, small(random), random.index(2) == 0 ? 0 : small(random)));
}
Solid flat_cone(RandomSolids& random) { return anyhow(random, cylinder(small(random), 1, random.number(0, 0.9))); }
Solid flake(RandomSolids& random) { return anyhow(random, box({small(random), small(random), 1})); }
Solid slit(RandomSolids& random) {
  return box({2, 2, 2}, Centering::centered) -
         anyhow(random, box({small(random), 3, random.index(2) == 0 ? 3 : small(random)}, Centering::centered));
}
Solid flat_ellipsoid(RandomSolids& random) { return anyhow(random, ellipsoid({small(random), small(random), 1})); }
Solid half_space_by_a_tiny_part(RandomSolids& random) {
  const double size = small(random);
  const Solid part = random.index(2) == 0 ? sphere(size) : box({size, size, size}, Centering::centered);
  return (part & halfspace({random.number(-1, 1), random.number(-1, 1), 1}, size * random.number(-0.5, 0.5))) +
         somewhere(random, sphere(1));
}
Solid leaning_half_space(RandomSolids& random) {
  return box({1, 1, 1}, Centering::centered) -
         halfspace({signed_small(random), signed_small(random), 1}, signed_small(random) / 4);
}
Solid thin_shell(RandomSolids& random) {
  return anyhow(random, sphere(1) - sphere(1 - scaled(random, -52, -2))) + at(tiny_ball(random), {3, 0, 0});
}
Solid any_quadric(RandomSolids& random) {
  const std::array<double, 6> matrix{signed_small(random), signed_small(random), signed_small(random), 0, 0, 0};
  return anyhow(random, quadric(matrix, {signed_small(random), signed_small(random), signed_small(random)},
                                signed_small(random)) &
                            box({2, 2, 2}, Centering::centered));
}

// Hard rays of every kind, and rays into the boxes of the solid's nodes.
Trial with_rays(RandomSolids& random, Solid solid, int rays) {
  Trial trial{std::move(solid), {}};
  const Scene scene = compile(trial.solid);
  verify::AdversarialRays hard(scene);
  verify::Random source(random.index(std::size_t{1} << 30));
  const std::size_t kinds = verify::AdversarialRays::kinds().size();
  const auto nodes = scene.nodes();
  for (int i = 0; i < rays; ++i) {
    if (random.index(2) == 0 || nodes.empty()) {
      hard.make(random.index(kinds), source, 1, trial.rays);
      continue;
    }
    const Box box = nodes[random.index(nodes.size())].box;
    if (!box.is_finite()) continue;
    const Vector size = box.size();
    const Point target =
        box.lower + Vector{size.x * random.number(0, 1), size.y * random.number(0, 1), size.z * random.number(0, 1)};
    const double distance = random.index(2) == 0 ? 3 : scaled(random, -10, 10) * std::max({size.x, size.y, size.z});
    const Vector d = random.direction();
    add(trial, target - distance * d, d);
  }
  return trial;
}

}  // namespace

std::vector<Family> extreme_families() {
  const std::vector<std::pair<std::string, Solid (*)(RandomSolids&)>> solids{
      {"balls of 2^-300 to 1 beside others", tiny_balls},
      {"boxes of 2^-300 to 1 beside others", tiny_boxes},
      {"cylinders and cones of 2^-300 to 1 beside others", tiny_cylinders},
      {"quadrics of 2^-300 to 1 beside others", tiny_quadrics},
      {"balls up to 2^300 away", far_balls},
      {"boxes up to 2^300 away", far_boxes},
      {"quadrics up to 2^300 away", far_curved},
      {"paraboloids of height 2^-300 to 1", flat_paraboloid},
      {"paraboloids of height 1 to 2^300", steep_paraboloid},
      {"hyperboloids of height 2^-300 to 1", flat_hyperboloid},
      {"hyperboloids of height 1 to 2^300", tall_hyperboloid},
      {"cylinders of radius 2^-300 to 1", needle},
      {"cones of radius 2^-300 to 1", thin_cone},
      {"cones of height 2^-300 to 1", flat_cone},
      {"boxes with sides of 2^-300 to 1", flake},
      {"slits of 2^-300 to 1", slit},
      {"ellipsoids with axes of 2^-300 to 1", flat_ellipsoid},
      {"half-spaces by parts of 2^-300 to 1", half_space_by_a_tiny_part},
      {"half-spaces that lean by 2^-300 to 1", leaning_half_space},
      {"shells of 2^-52 to 2^-2", thin_shell},
      {"quadrics with coefficients of 2^-300 to 1", any_quadric}};
  std::vector<Family> list;
  for (const auto& [name, make] : solids) {
    list.push_back(
        {name, [make = make](RandomSolids& random, int rays) { return with_rays(random, make(random), rays); }});
  }
  return list;
}

}  // namespace csgcast::stress
