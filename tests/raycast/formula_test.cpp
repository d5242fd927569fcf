// SPDX-License-Identifier: MIT
// Formulas in boxes: whatever is left out of them, their value stays what it is at the points of the box.
#include "raycast/cells/formula/formula.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "csg/solid/primitives.h"
#include "raycast/cells/build/box_fold.h"
#include "raycast/cells/build/cell_ground.h"
#include "raycast/cells/formula/formula_table.h"
#include "raycast/cells/formula/implied_fold.h"
#include "raycast/cells/formula/surface_set.h"
#include "tests/support/catch.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using detail::BoxFold;
using detail::Formula;
using detail::Term;
using test::RandomSolids;

namespace {

// The value of a term, by the definition of its operator. `positive(surface)`: the side that is asked for.
template <class Positive>
bool value_of(std::span<const Term> term, Positive&& positive) {
  const Term& top = term.front();
  if (top.op == Term::Op::half_space) return positive(top.surface()) == top.wants_positive();
  std::vector<bool> operands;
  for (std::size_t at = 1; at < term.size(); at += term[at].size)
    operands.push_back(value_of(term.subspan(at, term[at].size), positive));
  bool any = false, all = true, any_but_first = false;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    any = any || operands[k];
    all = all && operands[k];
    any_but_first = any_but_first || (k > 0 && operands[k]);
  }
  switch (top.op) {
    case Term::Op::unite:
      return any;
    case Term::Op::subtract:
      return operands.front() && !any_but_first;
    case Term::Op::complement:
      return !operands.front();
    default:
      return all;
  }
}

template <class Positive>
bool value_of(const Formula& formula, Positive&& positive) {
  return formula.is_constant() ? formula.value : value_of(std::span(formula.terms), positive);
}

// A scene's formula in a small box, and points of that box.
struct Look {
  Look(const Scene& scene, RandomSolids& random)
      : ground(scene, scene.root()), whole(detail::formula_of(scene, scene.root())) {
    const Vector middle = random.point(0.4) - Point{};
    half = {random.number(0.01, 0.2), random.number(0.01, 0.2), random.number(0.01, 0.2)};
    box = {middle - half, middle + half};
    for (int i = 0; i < 40; ++i) {
      Vector q;
      for (std::size_t axis = 0; axis < 3; ++axis) q[axis] = random.number(box.lower[axis], box.upper[axis]);
      points.push_back(q);
    }
  }

  bool value_at(const Formula& formula, Vector q) const {
    return value_of(formula, [&](SurfaceId id) { return local_form(ground.forms[id.index()], {q, q}).value > 0; });
  }

  detail::CellGround ground;
  Formula whole;
  Vector half;
  CellBox box;
  std::vector<Vector> points;
};

}  // namespace

TEST_CASE("a set of surfaces has each surface of a formula once, in its place") {
  RandomSolids random(31);
  for (int round = 0; round < 50; ++round) {
    const Scene scene = compile(random.tree(3));
    const Formula formula = detail::formula_of(scene, scene.root());
    detail::SurfaceSet set(scene.surfaces().size());
    set.gather(formula);
    std::vector<bool> is_used(scene.surfaces().size(), false);
    for (const Term& term : formula.terms) {
      if (term.op == Term::Op::half_space) is_used[term.surface().index()] = true;
    }
    const auto check = [&] {
      for (std::size_t i = 0; i < set.size(); ++i) CHECK(set.place_of(set[i]) == i);
    };
    check();
    for (std::uint32_t i = 0; i < is_used.size(); ++i) CHECK(set.contains(SurfaceId(i)) == is_used[i]);
    set.sort([](SurfaceId a, SurfaceId b) { return b < a; });
    check();
    if (set.size() < 3) continue;
    const std::vector<SurfaceId> before(set.list().begin(), set.list().end());
    set.keep(std::vector<std::size_t>{0, 2});
    check();
    CHECK(set.size() == 2);
    CHECK(set.contains(before[2]));
    CHECK_FALSE(set.contains(before[1]));
  }
}

TEST_CASE("the table of a formula has its value in every state") {
  RandomSolids random(37);
  std::size_t tables = 0, narrowed = 0;
  detail::FormulaTable table;
  for (int round = 0; round < 400; ++round) {
    // The value of a ball in two halves does not depend on the plane between them.
    const Solid halves = (sphere(1) & halfspace({1, 0, 0}, 0)) + (sphere(1) & halfspace({-1, 0, 0}, 0));
    const Scene scene = compile(round % 8 == 0 ? halves : random.tree(2));
    Look look(scene, random);
    Formula formula;
    BoxFold(look.ground, BoxFold::Places::exact).fold(look.whole, look.box, formula);
    detail::SurfaceSet surfaces(scene.surfaces().size());
    surfaces.gather(formula);
    if (formula.is_constant() || surfaces.size() > TruthTable::most_values) continue;
    table.tabulate(formula, surfaces);
    const TruthTable function = table.as_function();
    const auto value_in = [&](std::size_t state) {
      return value_of(formula, [&](SurfaceId id) { return (state >> surfaces.place_of(id) & 1) != 0; });
    };
    for (std::size_t state = 0; state < 256; ++state) CHECK(function.at(state) == value_in(state));
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      CHECK(table.depends_on(i) == function.depends_on(i));
      if (table.depends_on(i)) kept.push_back(i);
    }
    ++tables;
    if (kept.size() > 6) continue;
    const std::uint64_t word = table.over(kept);
    for (std::size_t state = 0; state < 64; ++state) {
      std::size_t wide = 0;
      for (std::size_t i = 0; i < kept.size(); ++i) wide |= (state >> i & 1) << kept[i];
      CHECK((word >> state & 1) == (function.at(wide) ? 1 : 0));
    }
    narrowed += kept.size() < surfaces.size() ? 1 : 0;
  }
  CHECK(tables > 50);
  CHECK(narrowed > 0);
}

TEST_CASE("a formula folded in a box has the same value at the points of the box") {
  RandomSolids random(41);
  std::size_t shorter = 0, implied = 0;
  detail::ImpliedFold implied_fold;
  detail::Implications implications;
  for (int round = 0; round < 300; ++round) {
    const Scene scene = compile(random.tree(4));
    Look look(scene, random);
    for (const BoxFold::Places places : {BoxFold::Places::exact, BoxFold::Places::of_rays}) {
      Formula folded;
      BoxFold(look.ground, places).fold(look.whole, look.box, folded);
      for (const Vector& q : look.points) CHECK(look.value_at(folded, q) == look.value_at(look.whole, q));
      shorter += folded.terms.size() < look.whole.terms.size() ? 1 : 0;
      detail::SurfaceSet surfaces(scene.surfaces().size());
      surfaces.gather(folded);
      if (!detail::ImpliedFold::is_worthwhile(folded, surfaces)) continue;
      implications.begin(surfaces.size(), look.half);
      for (std::size_t i = 0; i < surfaces.size(); ++i)
        implications.add(i, look.ground.form_in(surfaces[i].index(), look.box));
      Formula simpler;
      if (!implied_fold.fold(folded, surfaces, implications, simpler)) continue;
      CHECK(simpler.terms.size() < folded.terms.size());
      for (const Vector& q : look.points) CHECK(look.value_at(simpler, q) == look.value_at(folded, q));
      ++implied;
    }
  }
  CHECK(shorter > 100);
  CHECK(implied > 20);
}
