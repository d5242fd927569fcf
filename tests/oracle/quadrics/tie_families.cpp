// SPDX-License-Identifier: MIT
#include "tests/oracle/quadrics/tie_families.h"

#include <fmt/format.h>

#include "csg/solid/primitives.h"
#include "tests/stress/aimed_rays.h"

namespace csgcast::oracle::quadrics {
namespace {

using test::RandomSolids;
using LeafMaker = Solid (*)(RandomSolids&);

// Looks differ in one number only, which names them.
Solid maybe_dressed(RandomSolids& random, Solid solid) {
  const double name = static_cast<double>(1 + random.index(6));
  switch (random.index(4)) {
    case 0: {
      Material material;
      material.shininess = name;
      return with_look(std::move(solid), {material, std::nullopt});
    }
    case 1:
      return with_look(std::move(solid), {std::nullopt, Paint{{name / 8, 0, 0}, 1}});
    default:
      return solid;
  }
}

Solid dressed_tree(RandomSolids& random, std::size_t leaves, LeafMaker leaf) {
  if (leaves == 1) return maybe_dressed(random, leaf(random));
  Solid a = dressed_tree(random, leaves - leaves / 2, leaf);
  Solid b = dressed_tree(random, leaves / 2, leaf);
  constexpr Solid (*operations[])(Solid, Solid) = {
      [](Solid x, Solid y) { return std::move(x) + std::move(y); },
      [](Solid x, Solid y) { return std::move(x) + std::move(y); },
      [](Solid x, Solid y) { return std::move(x) & std::move(y); },
      [](Solid x, Solid y) { return std::move(x) - std::move(y); },
      [](Solid x, Solid y) { return std::move(x) - std::move(y); },
      [](Solid x, Solid y) { return std::move(x) & complement(std::move(y)); },
  };
  return maybe_dressed(random, operations[random.index(6)](std::move(a), std::move(b)));
}

// The first solid is in no part.
Solid union_of_parts(RandomSolids& random, std::size_t leaves, LeafMaker leaf) {
  std::vector<Solid> solids;
  for (std::size_t i = 0; i < 3; ++i) {
    Solid solid = dressed_tree(random, leaves, leaf);
    if (i > 0) solid = named(std::move(solid), {fmt::format("part {}", i), 1});
    solids.push_back(maybe_dressed(random, std::move(solid)));
  }
  return unite(std::move(solids));
}

Solid grid_leaf(RandomSolids& random) { return random.index(4) == 0 ? random.leaf() : random.grid_box(); }

Vector small_integers(RandomSolids& random) {
  for (;;) {
    const auto number = [&random] { return static_cast<double>(random.index(5)) - 2; };
    const double x = number(), y = number();
    const Vector v{x, y, number()};
    if (v != Vector{}) return v;
  }
}

// Of its bounding surfaces at least one passes through the origin.
Solid leaf_through_origin(RandomSolids& random) {
  const double side = random.index(2) == 0 ? 1 : -1;
  switch (random.index(8)) {
    case 0:
    case 1:
    case 2:
      return halfspace(small_integers(random), 0);
    case 3: {  // a corner of it is the origin, or an edge or face holds it
      const Vector corner{-static_cast<double>(random.index(3)), -static_cast<double>(random.index(3)), 0};
      return transformed(box({2, 2, 2}), translation(corner));
    }
    case 4:
      return transformed(sphere(1), translation({side, 0, 0}));
    case 5:
      return transformed(cylinder(6, 1, 1, Centering::centered), translation({0, side, 0}));
    case 6:
      return transformed(paraboloid(4, 2), scaling({1, 1, side}));
    default:  // the apex of a double cone
      return quadric({1, 1, -1, 0, 0, 0}, {}, 0);
  }
}

stress::Trial trial_through_one_point(RandomSolids& random, int rays) {
  const Vector offset{random.quarter(-2, 2), random.quarter(-2, 2), random.quarter(-2, 2)};
  stress::Trial trial{transformed(union_of_parts(random, 5, leaf_through_origin), translation(offset)), {}};
  for (int i = 0; i < rays; ++i) {
    const Vector d = small_integers(random);
    const double back = random.quarter(0, 4);
    trial.rays.emplace_back(Point{} + offset - back * d, d);
  }
  return trial;
}

}  // namespace

stress::Family looks_and_parts() {
  return {"looks and parts", [](RandomSolids& random, int rays) {
            stress::Trial trial{union_of_parts(random, 3, grid_leaf), {}};
            stress::aim_at_grid(random, trial, rays);
            return trial;
          }};
}

stress::Family surfaces_through_one_point() { return {"surfaces through one point", trial_through_one_point}; }

}  // namespace csgcast::oracle::quadrics
