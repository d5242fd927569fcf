// SPDX-License-Identifier: MIT
// A kind of surface that a line meets three times, and leaves that are truth functions: the engine knows neither.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "csg/base/transform.h"
#include "csg/solid/primitives.h"
#include "raycast/cells/cells.h"
#include "raycast/packets/packet_caster.h"
#include "raycast/ray/caster.h"
#include "raycast/scene/detail/compile.h"
#include "tests/support/batches.h"
#include "tests/support/brute_force.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/planted.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using test::check_lists;
using test::cut_cube;
using test::cut_cube_of_boxes;
using test::DepartingRays;
using test::grid_ray;
using test::l_prism;
using test::l_prism_of_boxes;
using test::RandomSolids;
using test::rays_at;
using test::Shots;

namespace {

Scene compiled(const Solid& solid, const Welding& welding = {}) {
  return detail::compile(solid, welding, test::planted_kinds());
}

// A quarter turn, a mirror or neither, half the size or not, and a step on the grid: faces of several solids coincide.
Solid on_grid(const Solid& solid, RandomSolids& random) {
  const double size = random.index(2) == 0 ? 1 : 0.5;
  const Vector turn = random.index(2) == 0 ? Vector{0, 0, 90} : Vector{90, 0, 0};
  const Vector step{random.quarter(-1, 1), random.quarter(-1, 1), random.quarter(-1, 1)};
  const Solid sized = transformed(solid, scaling({random.index(2) == 0 ? size : -size, size, size}));
  return transformed(transformed(sized, rotation(turn)), translation(step));
}

Solid planted_leaf(RandomSolids& random) {
  switch (random.index(4)) {
    case 0:
      return on_grid(l_prism(true), random);
    case 1:
      return on_grid(l_prism(false), random);
    case 2:
      return on_grid(cut_cube(0.25, 0.5, 0.75), random);
    default:
      return random.grid_box();
  }
}

// The part of a list from the start of a ray on.
std::vector<test::DefinedInterval> from_start(std::vector<test::DefinedInterval> list) {
  std::erase_if(list, [](const auto& interval) { return interval.exit.surface.valid() && interval.exit.t <= 0; });
  if (!list.empty() && (!list.front().entry.surface.valid() || list.front().entry.t < 0)) list.front().entry = {};
  return list;
}

void compare(Caster& caster, const Ray& ray, const std::optional<Departure>& departure) {
  const Scene& scene = caster.scene();
  auto defined = test::intervals_by_definition(scene, ray, test::in_l_prism, departure);
  if (departure) defined = from_start(std::move(defined));
  caster.begin(ray, departure);
  IntervalList list;
  caster.intervals(list, departure ? Span{} : Span::line());
  test::check_list(caster, list, defined);
}

// Both widths, every instruction set; `most_left`: so great a share of the rays may be left to the caster.
void check_packets(const Scene& scene, RandomSolids& random, double most_left) {
  const Cells cells(scene);
  std::vector<Ray> rays = rays_at(random, 400);
  for (int i = 0; i < 100; ++i) rays.push_back(grid_ray(random));
  Shots shots(rays);
  const DepartingRays departing(scene, random, rays);
  for (const auto instructions : PacketCaster::instruction_sets()) {
    for (const PacketCaster::Width width : {PacketCaster::Width::packet, PacketCaster::Width::single}) {
      PacketCaster caster(cells, width, instructions);
      check_lists(cells, caster, shots.rays.arrays(), shots.rays);
      CHECK(static_cast<double>(caster.left_to_caster().size()) <= most_left * static_cast<double>(rays.size()));
      check_lists(cells, caster, departing.arrays(), departing.rays);
    }
  }
}

// Lists, without whose face an end is: another tree of the same set has it.
void check_same_set(const Scene& scene, const Scene& other, RandomSolids& random, int rays) {
  Caster caster(scene);
  Caster expected(other);
  IntervalList list, others;
  for (int i = 0; i < rays; ++i) {
    const Ray ray(random.point(3), random.direction());
    caster.begin(ray);
    expected.begin(ray);
    caster.intervals(list, Span::line());
    expected.intervals(others, Span::line());
    REQUIRE(list.size() == others.size());
    for (std::size_t k = 0; k < list.size(); ++k) {
      CHECK(list[k].entry.t == Approx(others[k].entry.t).margin(1e-13));
      CHECK(list[k].exit.t == Approx(others[k].exit.t).margin(1e-13));
    }
  }
}

}  // namespace

TEST_CASE(
    "planted leaves and surfaces among grid boxes: lists, bounding surfaces and leaves are those of the definition") {
  RandomSolids random(31);
  for (int n = 0; n < test::times(250); ++n) {
    const Scene scene = compiled(random.tree(1 + n % 6, [&] { return planted_leaf(random); }));
    Caster caster(scene);
    for (int i = 0; i < 40; ++i) compare(caster, grid_ray(random), {});
  }
}

TEST_CASE("rays that depart from planted surfaces and leaves: the same") {
  RandomSolids random(32);
  int departures = 0;
  for (int n = 0; n < test::times(200); ++n) {
    const Scene scene = compiled(random.tree(1 + n % 4, [&] { return planted_leaf(random); }));
    Caster caster(scene);
    for (int i = 0; i < 20; ++i) {
      const Ray ray = grid_ray(random);
      for (std::uint32_t id = 0; id < scene.surfaces().size(); ++id) {
        if (sign_at(scene.surface(SurfaceId(id)), ray.origin()) != 0) continue;
        for (const Sense side : {Sense::negative, Sense::positive}) {
          compare(caster, ray, Departure{SurfaceId(id), side});
          ++departures;
        }
      }
    }
  }
  CHECK(departures > test::times(2000));
}

TEST_CASE("points are inside planted solids as they are inside the same sets of boxes") {
  RandomSolids random(33);
  const Scene l = compiled(l_prism(true) - cut_cube(0.25, 0.5, 0.75));
  const Scene boxes = compiled(l_prism_of_boxes() - cut_cube_of_boxes(0.25, 0.5, 0.75));
  Caster caster(l);
  Caster expected(boxes);
  int boundaries = 0;
  for (int i = 0; i < 4000; ++i) {
    const Point p =
        i % 2 == 0 ? random.point(2) : Point{random.quarter(0, 2), random.quarter(0, 2), random.quarter(0, 1)};
    const Location here = caster.locate(p);
    // Where only faces between the boxes of a union pass, the L is inside, and so is the union.
    CHECK(here == expected.locate(p));
    boundaries += here == Location::boundary ? 1 : 0;
  }
  CHECK(boundaries > 100);
}

TEST_CASE("packets decide rays through truth functions of planes: tables, steps, boxes") {
  RandomSolids random(34);
  check_packets(compiled(l_prism(true) - transformed(box({1, 1, 1}), translation({0.5, 0.5, 0.5}))), random, 0.4);
  check_packets(compiled(transformed(l_prism(true), rotation({30, 40, 50})) + sphere(0.6)), random, 0.4);
  check_packets(compiled(l_prism(false) & sphere(1.5)), random, 0.4);
  std::vector<Solid> many{l_prism(true)};
  for (int i = 0; i < 20; ++i) many.push_back(random.grid_box());
  check_packets(compiled(unite(many)), random, 0.6);
  std::vector<Solid> apart;
  for (int i = 0; i < 60; ++i)
    apart.push_back(transformed(transformed(l_prism(true), rotation({40.0 * i, 25.0 * i, 0})),
                                translation(as_vector(random.point(20)))));
  const Scene scene = compiled(unite(apart));
  CHECK(Cells(scene).counts().boxed > 0);
  check_packets(scene, random, 0.4);
}

TEST_CASE("cells leave rays to the caster only where a surface without lanes may be, or a leaf has yet to tell") {
  RandomSolids random(35);
  const Scene cut = compiled(cut_cube(0.25, 0.5, 0.75) + transformed(sphere(0.4), translation({-1, 0, 0})));
  check_packets(cut, random, 0.9);
  const Scene l = compiled((l_prism(true) - sphere(0.5)) + transformed(sphere(0.4), translation({-1, 0, 0})));
  for (const bool tells_terms : {false, true}) {
    const Scene reluctant = test::with_reluctant_leaves(l, 1, tells_terms);
    check_packets(reluctant, random, 0.9);
    // Elsewhere lanes decide: a view past the leaf leaves hardly any.
    const Cells cells(reluctant);
    PacketCaster caster(cells);
    std::vector<Ray> rays;
    for (int i = 0; i < 64; ++i)
      rays.emplace_back(Point{-1.3 + 0.01 * (i % 8), -3, -0.3 + 0.01 * i}, Vector{0, 1, 0.003});
    IntervalBatch batch;
    caster.intervals(rays, batch, {}, Rounding::close);
    CHECK(caster.left_to_caster().size() < rays.size() / 4);
  }
}

TEST_CASE("planted leaves moved, welded, subtracted and cut are the same sets as trees of boxes") {
  RandomSolids random(36);
  for (int n = 0; n < test::times(20); ++n) {
    const Vector step = as_vector(random.point(1));
    const auto moved = [&](const Solid& solid) {
      return transformed(transformed(solid, rotation({37.0 * n, 11.0 * n, 5.0 * n})), translation(step));
    };
    const Solid other = random.leaf();
    for (const Welding& welding : {Welding{}, Welding::derived(), Welding::by_hand(0x1p-12)}) {
      check_same_set(compiled(moved(l_prism(true)) - other, welding),
                     compiled(moved(l_prism_of_boxes()) - other, welding), random, 40);
      check_same_set(compiled(other - moved(cut_cube(0.25, 0.5, 0.75)), welding),
                     compiled(other - moved(cut_cube_of_boxes(0.25, 0.5, 0.75)), welding), random, 40);
    }
  }
}

TEST_CASE("a truth function stays what it is where two of its surfaces weld, or are equal from the start") {
  const Solid l = l_prism(true);
  const Solid neighbour = transformed(box({1, 1, 1}), translation({-1 - 1e-9, 0, 0}));
  const Scene apart = compiled(l + neighbour);
  const Scene welded = compiled(l + neighbour, Welding::by_hand(0x1p-20));
  CHECK(welded.surfaces().size() < apart.surfaces().size());
  Caster caster(welded);
  IntervalList list;
  caster.begin(Ray({-3, 0.5, 0.5}, {1, 0, 0}));
  caster.intervals(list, Span::line());
  CHECK(list.size() == 1);
}

TEST_CASE("cuts of planted leaves show the look of what they cut") {
  LookStatement red;
  red.paint = Paint{{1, 0, 0}, 1};
  const Solid cut = with_look(box({2, 2, 1}), red) - transformed(l_prism(true), translation({1, 1, 0}));
  const Scene scene = compiled(cut);
  Caster caster(scene);
  caster.begin(Ray({-1, 1.5, 0.5}, {1, 0, 0}));
  const auto hit = caster.first_hit();
  REQUIRE(hit);
  caster.begin(Ray({1.5, -1, 0.5}, {0, 1, 0}));
  IntervalList list;
  caster.intervals(list, Span::line());
  REQUIRE(list.size() == 1);
  CHECK(list[0].exit.t == 2);
  const Attribution face = caster.attribute({list[0].exit, Passage::exit});
  CHECK(scene.leaf(face.leaf).function != nullptr);
  CHECK(scene.look(face.look).color.r == 1);
}
