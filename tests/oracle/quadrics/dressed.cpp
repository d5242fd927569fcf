// SPDX-License-Identifier: MIT
#include "tests/oracle/quadrics/dressed.h"

#include <fmt/format.h>

#include "tests/stress/aimed_rays.h"

namespace csgcast::oracle::quadrics {
namespace {

using test::RandomSolids;

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

Solid dressed_leaf(RandomSolids& random) {
  return maybe_dressed(random, random.index(4) == 0 ? random.leaf() : random.grid_box());
}

Solid dressed_tree(RandomSolids& random, int leaves) {
  if (leaves == 1) return dressed_leaf(random);
  Solid a = dressed_tree(random, leaves - leaves / 2);
  Solid b = dressed_tree(random, leaves / 2);
  constexpr Solid (*operations[])(Solid, Solid) = {
      [](Solid x, Solid y) { return std::move(x) + std::move(y); },
      [](Solid x, Solid y) { return std::move(x) & std::move(y); },
      [](Solid x, Solid y) { return std::move(x) - std::move(y); },
      [](Solid x, Solid y) { return std::move(x) - std::move(y); },
      [](Solid x, Solid y) { return std::move(x) & complement(std::move(y)); },
  };
  return maybe_dressed(random, operations[random.index(5)](std::move(a), std::move(b)));
}

stress::Trial dressed_trial(RandomSolids& random, int rays) {
  std::vector<Solid> solids;
  for (int i = 0; i < 3; ++i) {
    Solid solid = dressed_tree(random, 3);
    if (i > 0) solid = named(std::move(solid), {fmt::format("part {}", i), 1});
    solids.push_back(maybe_dressed(random, std::move(solid)));
  }
  stress::Trial trial{unite(std::move(solids)), {}};
  stress::aim_at_grid(random, trial, rays / 2);
  stress::aim_at_middle(random, trial, rays / 2);
  return trial;
}

}  // namespace

stress::Family dressed_solids() { return {"looks and parts", dressed_trial}; }

}  // namespace csgcast::oracle::quadrics
