// SPDX-License-Identifier: MIT
// Surfaces that others imply are left out of cells, and nobody notices but by the time it takes.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "csg/base/transform.h"
#include "csg/solid/primitives.h"
#include "raycast/cells/build/cell_ground.h"
#include "raycast/cells/cells.h"
#include "raycast/cells/formula/implications.h"
#include "raycast/packets/packet_caster.h"
#include "tests/support/at.h"
#include "tests/support/batches.h"
#include "tests/support/catch.h"
#include "tests/support/chain.h"
#include "tests/support/effort.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using detail::Implications;
using test::ball;
using test::check_lists;
using test::flat;
using test::Link;
using test::nested;
using test::RandomSolids;
using test::rays_at;

namespace {

double value_at(const CellForm& form, Vector q) { return local_form(form, {q, q}).value; }

std::size_t surfaces_in_cells(const Solid& solid) { return Cells(compile(solid)).counts().surfaces; }

void check_packets(const Solid& solid, RandomSolids& random, std::size_t count) {
  const Scene scene = compile(solid);
  const Cells cells(scene);
  const test::RayBatch batch(rays_at(random, count));
  for (const PacketCaster::Width width : {PacketCaster::Width::packet, PacketCaster::Width::single}) {
    PacketCaster caster(cells, width);
    check_lists(cells, caster, batch.arrays(), batch);
    CHECK(caster.left_to_caster().size() < count / 10);
  }
}

// Union, difference, intersection in turn.
std::vector<Link> chain(RandomSolids& random, std::size_t length) {
  std::vector<Link> links;
  for (std::size_t i = 0; i < length; ++i) {
    const bool is_large = i % 3 == 2;
    const Point at = random.point(is_large ? 0.12 : 0.6);
    links.push_back({static_cast<Link::Op>(i % 3), ball(at - Point{}, is_large ? 1 : random.number(0.3, 0.5))});
  }
  return links;
}

}  // namespace

TEST_CASE("what implications say of a box is so at all its points") {
  RandomSolids random(3);
  std::size_t found = 0;
  for (int round = 0; round < 300; ++round) {
    const Scene scene = compile(random.tree(3));
    const detail::CellGround ground(scene, scene.root());
    const Point middle = random.point(0.5);
    const Vector half{random.number(0.01, 0.3), random.number(0.01, 0.3), random.number(0.01, 0.3)};
    const CellBox box{(middle - Point{}) - half, (middle - Point{}) + half};
    const std::size_t count = std::min(scene.surfaces().size(), Implications::most);
    Implications implications;
    implications.begin(count, half);
    for (std::size_t i = 0; i < count; ++i) implications.add(i, ground.form_in(i, box));
    for (int sample = 0; sample < 60; ++sample) {
      Vector q;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t end = random.index(4);  // corners, edges and sides as well
        q[axis] = end == 0   ? box.lower[axis]
                  : end == 1 ? box.upper[axis]
                             : random.number(box.lower[axis], box.upper[axis]);
      }
      Implications::Literals holds;
      for (std::size_t i = 0; i < count; ++i) holds.set(2 * i + (value_at(ground.forms[i], q) > 0 ? 1 : 0));
      for (std::size_t literal = 0; literal < 2 * count; ++literal) {
        if (!holds.test(literal)) continue;
        const Implications::Literals& implied = implications.by(literal);
        CHECK((implied & ~holds).none());
        found += implied.count() > 1 ? 1 : 0;
      }
    }
  }
  CHECK(found > 1000);
}

TEST_CASE("a form is negative at the corners that it is said to be negative at") {
  RandomSolids random(5);
  std::size_t negative = 0, count = 0;
  for (int round = 0; round < 100; ++round) {
    const Scene scene = compile(random.tree(3));
    const detail::CellGround ground(scene, scene.root());
    const Vector middle = random.point(0.5) - Point{};
    const Vector half{random.number(0.01, 0.3), random.number(0.01, 0.3), random.number(0.01, 0.3)};
    for (std::size_t i = 0; i < ground.forms.size(); ++i) {
      const LocalForm form = ground.form_in(i, {middle - half, middle + half});
      const std::uint32_t corners = detail::negative_corners(form, half);
      CHECK((corners & ~detail::all_corners) == 0);
      for (std::uint32_t corner = 0; corner < 8; ++corner) {
        Vector q;
        for (std::size_t axis = 0; axis < 3; ++axis)
          q[axis] = middle[axis] + ((corner >> axis & 1) != 0 ? half[axis] : -half[axis]);
        const double value = value_at(ground.forms[i], q);
        if (std::fabs(value) <= form.slack) continue;
        CHECK((value < 0) == ((corners >> corner & 1) != 0));
        negative += value < 0 ? 1 : 0;
        ++count;
      }
    }
  }
  CHECK(negative > count / 10);
  CHECK(negative < count - count / 10);
}

TEST_CASE("balls within balls, and apart from them, imply each other's sides") {
  const Scene scene = compile(unite({ball({0, 0, 0}, 0.4), ball({0.02, 0, 0}, 0.3), ball({0.9, 0, 0}, 0.4)}));
  const detail::CellGround ground(scene, scene.root());
  const auto surface_at = [&scene](Point p) {
    Caster caster(scene);
    caster.begin(Ray(p, {0, 0, 1}));
    return caster.first_hit()->crossing.surface.index();
  };
  const std::size_t outer = surface_at({0, 0, -2});
  const std::size_t right = surface_at({0.9, 0, -2});
  const std::size_t inner = 3 - outer - right;
  // Where the first two are, close to both.
  const double unit = std::ldexp(1.0, -scene.frame().exponent);
  const auto box_about = [&](Point p, double side) {
    const Vector q = unit * (p - scene.frame().center);
    const Vector half{side * unit, side * unit, side * unit};
    return CellBox{q - half, q + half};
  };
  const auto implications_in = [&](const CellBox& box) {
    Implications implications;
    implications.begin(3, 0.5 * (box.upper - box.lower));
    for (std::size_t i = 0; i < 3; ++i) implications.add(i, ground.form_in(i, box));
    return implications;
  };
  // Positive sides are outside or inside, as canonical forms have it: far out all are what outside is.
  const auto outside = [&](std::size_t i) { return 2 * i + (value_at(ground.forms[i], {3, 3, 3}) > 0 ? 1 : 0); };
  const auto implies = [](const Implications& all, std::size_t a, std::size_t b) { return all.by(a).test(b); };
  const Implications near = implications_in(box_about({0, 0, 0.35}, 0.1));
  CHECK(near.any());
  CHECK(implies(near, outside(inner) ^ 1, outside(outer) ^ 1));  // inside of the inner one is inside of the outer one
  CHECK(implies(near, outside(outer), outside(inner)));
  CHECK_FALSE(implies(near, outside(outer) ^ 1, outside(inner) ^ 1));
  const Implications between = implications_in(box_about({0.45, 0, 0}, 0.1));
  CHECK(implies(between, outside(outer) ^ 1, outside(right)));
  CHECK_FALSE(implies(between, outside(outer), outside(right)));
  const Implications all = implications_in(box_about({0, 0, 0}, 1.5));  // as it is everywhere
  CHECK(implies(all, outside(inner) ^ 1, outside(outer) ^ 1));
  CHECK_FALSE(implies(all, outside(inner), outside(outer)));
}

TEST_CASE("what others hide is not in cells") {
  const Solid outer = ball({0, 0, 0}, 1);
  const Solid inner = ball({0.1, 0, 0}, 0.85);
  CHECK(surfaces_in_cells(outer + inner) == surfaces_in_cells(outer + ball({0, 0, 0}, 0.01)));
  CHECK(surfaces_in_cells(outer & inner) == surfaces_in_cells(inner & box({4, 4, 4}, Centering::centered)));
  // Many shells of which one alone is seen.
  std::vector<Solid> shells;
  for (int i = 0; i < 20; ++i) shells.push_back(ball({0.001 * i, 0, 0}, 1 - 0.002 * i));
  const Cells::Counts counts = Cells(compile(unite(shells))).counts();
  CHECK(counts.large == 0);
  CHECK(counts.undecided == 0);
}

TEST_CASE("faces a ten-millionth apart do not crowd cells") {
  std::vector<Solid> plates;
  for (int i = 0; i < 24; ++i) plates.push_back(box({2, 2, 1 + 1e-7 * i}));
  for (const Solid& solid : {unite(plates), intersect(plates)}) {
    const Cells::Counts counts = Cells(compile(solid)).counts();
    CHECK(counts.large == 0);
    CHECK(counts.undecided == 0);
  }
}

TEST_CASE("a chain of operations, and the same solid written flat, show the same, as the scalar caster has it") {
  RandomSolids random(9);
  for (const std::size_t length : {std::size_t{6}, std::size_t{15}, std::size_t{31}}) {
    const std::vector<Link> links = chain(random, length);
    check_packets(nested(links), random, 600);
    check_packets(flat(links), random, 600);
    const Scene scenes[] = {compile(nested(links)), compile(flat(links))};
    const std::vector<Ray> rays = rays_at(random, 600);
    std::array<IntervalBatch, 2> batches;
    for (std::size_t i = 0; i < 2; ++i) {
      const Cells cells(scenes[i]);
      PacketCaster(cells).intervals(rays, batches[i]);
    }
    REQUIRE(batches[0].offsets == batches[1].offsets);
    for (std::size_t k = 0; k < batches[0].intervals.size(); ++k) {
      CHECK(batches[0].intervals[k].entry.t == batches[1].intervals[k].entry.t);
      CHECK(batches[0].intervals[k].exit.t == batches[1].intervals[k].exit.t);
    }
  }
}

TEST_CASE("a leaf that needs a face no longer is not taken to end there") {
  // Between bricks that touch nothing is seen of their common faces; farther on, the union goes on.
  std::vector<Solid> bricks;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) bricks.push_back(transformed(box({1, 1, 1}), translation({1.0 * i, 1.0 * j, 0})));
  }
  std::vector<Solid> parts{unite(bricks)};
  for (int i = 0; i < 6; ++i) parts.push_back(transformed(box({0.5, 6, 0.5}), translation({i + 0.25, 0, 0.5})));
  const Solid solid = transformed(transformed(subtract(parts), translation({-3, -3, -0.5})), scaling({0.3, 0.3, 0.3}));
  RandomSolids random(21);
  check_packets(solid, random, 3000);
  check_packets(transformed(solid, rotation(30, {1, 2, 3})), random, 1000);
}

TEST_CASE("no cell of a chain of balls keeps more surfaces than a table takes") {
  RandomSolids random(11);
  std::size_t large = 0;
  for (int round = 0; round < test::times(30); ++round) {
    const std::vector<Link> links = chain(random, 61);
    large += Cells(compile(nested(links))).counts().large + Cells(compile(flat(links))).counts().large;
  }
  CHECK(large == 0);
}
