// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <vector>

#include "csg/base/truth_table.h"
#include "csg/solid/primitives.h"
#include "measure/sheet/estimate.h"
#include "raycast/cells/pieces.h"
#include "raycast/ray/caster.h"
#include "tests/support/catch.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using test::RandomSolids;

namespace {

// A piece and its halves tell of the same space: what they say must go together.
void check_halves(const detail::Estimate& whole, const detail::Estimate& a, const detail::Estimate& b) {
  const double volume_error = whole.volume_error + a.volume_error + b.volume_error;
  CHECK(std::fabs(a.moments.volume + b.moments.volume - whole.moments.volume) <= volume_error + 1e-17);
  const double area_error = whole.area_error + a.area_error + b.area_error;
  CHECK(std::fabs(a.area + b.area - whole.area) <= area_error + 1e-16);
  for (std::size_t i = 0; i < 3; ++i) {
    const double error =
        whole.volume_error * whole.reach[i] + a.volume_error * a.reach[i] + b.volume_error * b.reach[i];
    CHECK(std::fabs(a.moments.first[i] + b.moments.first[i] - whole.moments.first[i]) <= error + 1e-16);
    const double square = whole.volume_error * whole.reach[i] * whole.reach[i] +
                          a.volume_error * a.reach[i] * a.reach[i] + b.volume_error * b.reach[i] * b.reach[i];
    CHECK(std::fabs(a.moments.second[i] + b.moments.second[i] - whole.moments.second[i]) <= square + 1e-16);
  }
}

// Cuts a solid's space at random `levels` deep along one random way, and checks every cut.
void check_cuts(const Solid& solid, RandomSolids& random, int ways, int levels) {
  const Scene scene = compile(solid);
  const Space space(scene);
  if (!space.is_bounded() || space.is_empty()) return;
  PieceCutter cutter(space);
  for (int way = 0; way < ways; ++way) {
    Piece piece = cutter.whole();
    detail::Estimate of_piece = detail::estimate(space, piece);
    for (int level = 0; level < levels && !piece.is_constant(); ++level) {
      const std::size_t axis = level < 6 ? static_cast<std::size_t>(level) % 3 : random.index(3);
      const double share = random.number(0.3, 0.7);
      const double at = piece.box.lower[axis] + share * (piece.box.upper[axis] - piece.box.lower[axis]);
      auto [lower, upper] = cutter.cut(piece, axis, at);
      const detail::Estimate of_lower = detail::estimate(space, lower);
      const detail::Estimate of_upper = detail::estimate(space, upper);
      INFO("way " << way << ", level " << level);
      check_halves(of_piece, of_lower, of_upper);
      const bool goes_down = upper.is_constant() || (!lower.is_constant() && random.index(2) == 0);
      piece = goes_down ? lower : upper;
      of_piece = goes_down ? of_lower : of_upper;
    }
  }
}

}  // namespace

TEST_CASE("A truth table restricted, renamed and put together again is the same function") {
  TruthTable table;
  for (std::size_t w = 0; w < TruthTable::words; ++w) table.word(w) = 0x123456789abcdef0u * (2 * w + 1);
  for (std::size_t i = 0; i < TruthTable::most_values; ++i) {
    CHECK(TruthTable::by(i, table.with(i, false), table.with(i, true)) == table);
    CHECK_FALSE(table.with(i, true).depends_on(i));
    for (std::size_t state = 0; state < 256; ++state) {
      const std::size_t set = state | std::size_t{1} << i;
      CHECK(table.with(i, true).at(state) == table.at(set));
      CHECK(table.with(i, false).at(state) == table.at(set ^ std::size_t{1} << i));
    }
  }
  const TruthTable narrow = table.with(7, true);
  for (std::size_t state = 0; state < 128; ++state)
    CHECK(narrow.renamed(0, 7).at((state & ~std::size_t{1}) | (state & 1) << 7) == narrow.at(state));
}

TEST_CASE("Pieces of random solids have the tree's values at random points") {
  RandomSolids random(11);
  std::size_t compared = 0;
  for (int round = 0; round < 60; ++round) {
    const Scene scene = compile(random.tree(2 + round % 9));
    const Space space(scene);
    if (!space.is_bounded() || space.is_empty()) continue;
    PieceCutter cutter(space);
    Caster caster(scene);
    Piece piece = cutter.whole();
    for (int level = 0; level < 24 && !piece.is_constant(); ++level) {
      const std::size_t axis = random.index(3);
      const double at =
          piece.box.lower[axis] + random.number(0.3, 0.7) * (piece.box.upper[axis] - piece.box.lower[axis]);
      auto [lower, upper] = cutter.cut(piece, axis, at);
      piece = random.index(2) == 0 ? lower : upper;
      if (piece.is_crowded()) continue;
      Vector u;
      for (std::size_t i = 0; i < 3; ++i) u[i] = random.number(piece.box.lower[i], piece.box.upper[i]);
      std::size_t state = 0;
      for (std::size_t i = 0; i < piece.count; ++i) {
        const CellForm& form = space.form(piece.surfaces[i]);
        const LocalForm here = local_form(form, {u, u});
        if (here.value > 0) state |= std::size_t{1} << i;
      }
      const Location location = caster.locate(space.in_scene(u));
      if (location == Location::boundary) continue;
      CHECK(piece.table.at(state) == (location == Location::inside));
      ++compared;
    }
  }
  CHECK(compared > 300);
}

TEST_CASE("What is told of a piece and of its halves goes together: random solids") {
  RandomSolids random(5);
  for (int round = 0; round < 150; ++round) check_cuts(random.tree(1 + round % 8), random, 4, 24);
}

TEST_CASE("What is told of a piece and of its halves goes together: flush boxes and rods") {
  RandomSolids random(6);
  const auto leaf = [&] {
    if (random.index(3) == 0) {
      const double r = random.quarter(0.25, 1);
      const Solid rod = cylinder(random.quarter(0.5, 2), r, random.index(2) == 0 ? r : random.quarter(0.25, 1));
      return transformed(rod, translation({random.quarter(-1, 1), random.quarter(-1, 1), random.quarter(-1, 1)}));
    }
    return random.grid_box();
  };
  for (int round = 0; round < 150; ++round) check_cuts(random.tree(2 + round % 7, leaf), random, 4, 24);
}

TEST_CASE("What is told of a piece and of its halves goes together: countersinks, shells, tangent balls") {
  RandomSolids random(7);
  const auto centered = Centering::centered;
  const Solid sunk = cylinder(1, 1, 1) - cylinder(4, 0.25, 0.25, centered) -
                     transformed(cylinder(0.25, 0.25, 0.5), translation({0, 0, 0.75}));
  const Solid shells = (sphere(1) - sphere(0.999)) + (sphere(0.5) - sphere(0.4999));
  const Solid tangent = cylinder(2, 1, 1, centered) - sphere(1);
  const Solid turned = transformed(sunk, rotation(30, Vector{1, 2, 3}));
  for (const Solid& solid : {sunk, shells, tangent, turned}) check_cuts(solid, random, 120, 30);
}
