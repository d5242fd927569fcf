// SPDX-License-Identifier: MIT
#include "raycast/cells/cells.h"
#include "raycast/cells/cells_data.h"

#include <tbb/task_arena.h>

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "csg/base/transform.h"
#include "csg/solid/primitives.h"
#include "raycast/cells/build/cell_data.h"
#include "raycast/packets/packet_caster.h"
#include "tests/support/batches.h"
#include "tests/support/catch.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using test::check_lists;
using test::check_same;
using test::DepartingRays;
using test::RandomSolids;
using test::rays_at;
using test::same;
using test::Shots;

namespace {

// A plate with rows of holes, square to the axes.
Solid plate() {
  std::vector<Solid> holes;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const Vector at{-0.75 + 0.5 * i, -0.75 + 0.5 * j, -1};
      holes.push_back(transformed((i + j) % 2 == 0 ? cylinder(2, 0.15, 0.15) : box({0.2, 0.2, 2}), translation(at)));
    }
  }
  return box({2, 2, 0.5}, Centering::centered) - unite(holes);
}

// Rays that look at the plate's face from some way off.
std::vector<Ray> view_of_plate(const Transform& turn) {
  const Scene eye_at = compile(transformed(transformed(sphere(0x1p-20), translation({1.5, -2, 3})), turn));
  const Point eye = eye_at.bounds().lower;
  std::vector<Ray> rays;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) rays.emplace_back(eye, Point{-1 + i / 32.0, -1 + j / 32.0, 0} - eye);
  }
  return rays;
}

std::size_t left_of(const Solid& solid, const std::vector<Ray>& rays) {
  const Scene scene = compile(solid);
  const Cells cells(scene);
  PacketCaster caster(cells);
  IntervalBatch batch;
  caster.intervals(rays, batch, {}, Rounding::close);
  return caster.left_to_caster().size();
}

}  // namespace

TEST_CASE("arrays of rays get the scalar caster's answers, however many there are") {
  RandomSolids random(11);
  for (const std::size_t count : {std::size_t{1}, std::size_t{7}, std::size_t{8}, std::size_t{17}, std::size_t{600}}) {
    const Scene scene = compile(random.tree(12) & box({4, 4, 4}, Centering::centered));
    const Cells cells(scene);
    Caster scalar(scene);
    PacketCaster packets(cells);
    const std::vector<Ray> rays = rays_at(random, count);
    Shots shots(rays);
    std::vector<std::uint8_t> any(count);
    IntervalBatch batch;
    for (const Rounding rounding : {Rounding::nearest, Rounding::close}) {
      packets.first_hits(shots.rays.arrays(), shots.hits(), rounding);
      packets.any_hits(shots.rays.arrays(), any);
      packets.intervals(shots.rays.arrays(), batch, rounding);
      REQUIRE(batch.offsets.size() == count + 1);
      for (std::size_t i = 0; i < count; ++i) {
        scalar.begin(rays[i]);
        const std::optional<Hit> hit = scalar.first_hit({}, rounding);
        REQUIRE((shots.state[i] != HitArrays::none) == hit.has_value());
        if (hit) {
          CHECK((shots.state[i] == HitArrays::entry) == (hit->passage == Passage::entry));
          CHECK(same({shots.t[i], SurfaceId(shots.surface[i]), shots.root[i]}, hit->crossing));
        }
        CHECK((any[i] != 0) == scalar.any_hit());
        IntervalList list;
        scalar.intervals(scene.root(), list, {}, rounding);
        check_same(batch.of(i), list);
      }
    }
  }
}

TEST_CASE("lists of rays that depart, and the faces at their ends, are the scalar caster's") {
  RandomSolids random(12);
  for (const int leaves : {2, 6, 20}) {
    const Scene scene = compile(random.tree(leaves) - transformed(sphere(0.6), translation({0.5, 0, 0})));
    const Cells cells(scene);
    const DepartingRays departing(scene, random, rays_at(random, 400));
    REQUIRE(departing.rays.size() > 20);
    for (const PacketCaster::Width width : {PacketCaster::Width::packet, PacketCaster::Width::single}) {
      PacketCaster caster(cells, width);
      check_lists(cells, caster, departing.arrays(), departing.rays);
      CHECK(caster.left_to_caster().size() < departing.rays.size());
    }
  }
}

TEST_CASE("whole lines in unbounded solids, of all directions in one packet, have the scalar caster's answers") {
  const std::vector<Solid> solids{halfspace({1, 0, 0}, -0.3),
                                  halfspace({1, 0, 0}, -0.3) - box({1, 1, 1}, Centering::centered),
                                  unite({halfspace({0, 0, 1}, -1), box({1, 2, 1}), halfspace({1, 1, 0}, -2)}),
                                  complement(box({2, 2, 2}, Centering::centered))};
  RandomSolids random(13);
  for (const Solid& solid : solids) {
    const Scene scene = compile(solid);
    const Cells cells(scene);
    Caster scalar(scene);
    std::vector<Ray> rays;
    std::vector<double> ends;
    for (int i = 0; i < 300; ++i) {
      const Vector along[]{{0, 0, -1}, {0, 1, 0}, {-1, 0, 0}, {0, -1, -1}};
      const Point o{random.number(-4, 4), random.number(-4, 4), random.number(-4, 4)};
      rays.emplace_back(o, i % 3 == 0 ? random.direction() : along[i % 4]);
      ends.push_back(i % 2 == 0 ? HUGE_VAL : 1);
    }
    Shots shots(rays);
    RayArrays lines = shots.rays.arrays();
    lines.whole_line = true;
    lines.end = ends;
    for (const PacketCaster::Width width : {PacketCaster::Width::packet, PacketCaster::Width::single}) {
      PacketCaster caster(cells, width);
      IntervalBatch batch;
      caster.intervals(lines, batch);
      std::vector<std::uint8_t> any(rays.size());
      caster.any_hits(lines, any);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        const Span span{-HUGE_VAL, ends[i]};
        scalar.begin(rays[i]);
        CHECK((any[i] != 0) == scalar.any_hit(span));
        IntervalList list;
        scalar.intervals(list, span);
        check_same(batch.of(i), list);
      }
    }
  }
}

TEST_CASE("a zero's sign does not change what lanes tell of a quadric") {
  const Solid cone =
      transformed(cylinder(1.5, 2.4999999999999, 2.5, Centering::centered), translation({1.41, 1.5, 0.5}));
  const Scene scene = compile(transformed(cone, scaling({1e6, 1e6, 1e6})));
  const Cells cells(scene);
  Caster scalar(scene);
  const std::vector<Ray> rays{Ray({0.5, 244239.43426779623, 653676.4319077125}, {0, -1, 0}),
                              Ray({1.41e6, -9e6, 653676.4319077125}, {0, 1, 0})};
  Shots shots(rays);
  for (const PacketCaster::Width width : {PacketCaster::Width::packet, PacketCaster::Width::single}) {
    PacketCaster caster(cells, width);
    caster.first_hits(shots.rays.arrays(), shots.hits(), Rounding::close);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      scalar.begin(rays[i]);
      CHECK(shots.t[i] == scalar.first_hit({}, Rounding::close)->crossing.t);
    }
  }
}

TEST_CASE("lists end where arrays of rays do") {
  const Scene scene = compile(sphere(1));
  const Cells cells(scene);
  PacketCaster caster(cells);
  Shots shots({Ray({0, 0, -3}, {0, 0, 1}), Ray({0, 0, 0}, {0, 0, 1}), Ray({0, 0, -3}, {0, 0, 1})});
  RayArrays rays = shots.rays.arrays();
  const std::array<double, 3> end{3, 0.5, 1};
  rays.end = end;
  IntervalBatch batch;
  caster.intervals(rays, batch);
  REQUIRE(batch.offsets == std::vector<std::size_t>{0, 1, 2, 2});
  CHECK(batch.intervals[0].entry.t == 2);
  CHECK(batch.intervals[0].exit.t == 3);
  CHECK_FALSE(batch.intervals[0].exit.surface.valid());
  CHECK(batch.intervals[1].entry.t == 0);
  CHECK(batch.intervals[1].exit.t == 0.5);
}

TEST_CASE("a turned scene costs no more cells, and lanes decide its rays as well") {
  const Transform turn = rotation(30, {1, 2, 3});
  const Cells::Counts straight = Cells(compile(plate())).counts();
  const Scene turned = compile(transformed(plate(), turn));
  const Cells::Counts counts = Cells(turned).counts();
  CHECK(counts.undecided == 0);
  CHECK(counts.cells < 2 * straight.cells);
  const std::vector<Ray> rays = view_of_plate(turn);
  CHECK(left_of(transformed(plate(), turn), rays) < rays.size() / 100);
}

TEST_CASE("rays that graze the edges of a turned solid are answered exactly, and those that pass it by meet no cells") {
  const Vector sides{4, 0.5, 0.25};
  RandomSolids random(47);
  for (const double size : {1.0, 0x1p-300, 0x1p300}) {
    const Transform turn = rotation(30, {1, 2, 3});
    const Vector offset = size * Vector{3, -2, 1};
    const Solid turned = transformed(box(size * sides, Centering::centered), turn);
    const Scene scene = compile(transformed(turned, translation(offset)));
    const Cells cells(scene);
    const auto place = [&](Vector at) {
      const auto row = [&](std::size_t i) { return size * dot(Vector{turn(i, 0), turn(i, 1), turn(i, 2)}, at); };
      return Point{} + Vector{row(0), row(1), row(2)} + offset;
    };
    // Through the box' own box along the scene's axes, which is as wide as it is long.
    std::vector<Ray> beside;
    std::vector<Ray> grazing;
    for (int i = 0; i < 400; ++i) {
      const double along = random.number(-2, 2);
      const Point edge = place({along, 0.25, i % 2 == 0 ? 0.125 : -0.125});
      const Vector direction = place({along + random.number(-2, 2), random.number(1, 2), random.number(-1, 1)}) -
                               place({along, random.number(-2, -1), random.number(-1, 1)});
      const double off = std::ldexp(size, -20 - i % 40);
      grazing.emplace_back(edge + Vector{off, -off, 0} - std::ldexp(1.0, i % 30) * direction, direction);
      beside.emplace_back(place({along, 0.75, -1}), place({0.1, 0, 1}) - place({0, 0, -1}));
    }
    const test::RayBatch batch(grazing);
    for (const PacketCaster::Width width : {PacketCaster::Width::packet, PacketCaster::Width::single}) {
      for (const std::string_view set : PacketCaster::instruction_sets()) {
        PacketCaster caster(cells, width, set);
        check_lists(cells, caster, batch.arrays(), batch);
        PacketCaster other(cells, width, set);
        IntervalBatch found;
        other.intervals(beside, found, {}, Rounding::close);
        CHECK(found.intervals.empty());
        CHECK(other.counts().nodes == 0);
      }
    }
  }
}

TEST_CASE("scenes of many directions have no cells that lanes cannot take") {
  std::vector<Solid> plates;
  for (int i = 0; i < 4; ++i) plates.push_back(transformed(plate(), rotation(10 + 20 * i, {1, 0.5 * i, 2})));
  const Scene scene = compile(unite(plates));
  CHECK(Cells(scene).counts().undecided < 10);
}

TEST_CASE("cells do not depend on the number of threads that build them") {
  RandomSolids random(3);
  std::vector<Solid> balls;
  for (int i = 0; i < 6000; ++i)
    balls.push_back(transformed(sphere(random.number(0.01, 0.06)), translation(as_vector(random.point(1)))));
  const Scene scene = compile(unite(std::move(balls)));
  const auto built_by = [&](int threads) {
    tbb::task_arena arena(threads);
    return arena.execute([&] { return Cells(scene); });
  };
  const Cells one = built_by(1), four = built_by(4);
  const detail::CellData &a = one.data(), &b = four.data();
  REQUIRE(a.nodes.size() == b.nodes.size());
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    REQUIRE(a.nodes[i].split == b.nodes[i].split);
    REQUIRE(a.nodes[i].above == b.nodes[i].above);
  }
  REQUIRE(a.cells.size() == b.cells.size());
  for (std::size_t i = 0; i < a.cells.size(); ++i) {
    REQUIRE(a.cells[i].table == b.cells[i].table);
    REQUIRE(a.cells[i].first_slot == b.cells[i].first_slot);
  }
  REQUIRE(a.slots.size() == b.slots.size());
  for (std::size_t i = 0; i < a.slots.size(); ++i)
    REQUIRE((a.slots[i].surface == b.slots[i].surface && a.slots[i].leaf == b.slots[i].leaf));
}

namespace {

// All intervals of a line by packets and by the definition.
void check_line(const Solid& solid, const Ray& ray) {
  const Scene scene = compile(solid, Welding::derived());
  const Cells cells(scene);
  Caster caster(scene);
  IntervalList expected;
  IntervalBatch batch;
  for (const Span span : {Span(), Span::line()}) {
    caster.begin(ray);
    caster.intervals(expected, span);
    for (const PacketCaster::Width width : {PacketCaster::Width::packet, PacketCaster::Width::single}) {
      PacketCaster packets(cells, width);
      packets.intervals(std::vector<Ray>{ray}, batch, span);
      REQUIRE(batch.intervals.size() == expected.size());
      for (std::size_t k = 0; k < expected.size(); ++k) {
        CHECK(same(batch.intervals[k].entry, expected[k].entry));
        CHECK(same(batch.intervals[k].exit, expected[k].exit));
      }
    }
  }
}

}  // namespace

TEST_CASE("a double cone that rounding gives a radius is no sphere") {
  const Solid cone = transformed(hyperboloid(2, 2, 0), translation({0.2, -1, 0.1}));
  RandomSolids random(17);
  for (int i = 0; i < 200; ++i) {
    const Point target = random.point(1.5) + Vector{0.2, -1, 0.1};
    const Vector d = random.direction();
    check_line(cone, Ray(target - 3.0 * d, d));
  }
}

TEST_CASE("a surface that is met twice within the lanes' tolerance does not hide") {
  const Solid cone = transformed(hyperboloid(2, 2, 0), translation({0.2, -1, 0.1}));
  check_line(cone, Ray({0.19999999999999996, -1.0000000000000004, 0.1}, {-4, 5.999999999999998, -3.999999999999999}));
  // Past the apex, at the distances at which the two crossings are closer than that.
  for (int n = 20; n < 60; ++n) {
    const double off = std::ldexp(1.0, -n);
    check_line(cone, Ray({-2.8, -1, 0.1 + off}, {3, 0, 0.25 * off}));
    check_line(cone - box({9, 9, 9}), Ray({0.2, -4, 0.1 - off}, {0, 3, 0}));
  }
}

TEST_CASE("the crossings next to an apex are told apart, each to the nearest double") {
  const Solid cone =
      transformed(transformed(hyperboloid(1.8, 0.9, 0), rotation(25, {0, 0, 1})), translation({-1.35, 0, 1.65}));
  // In a scene whose center is elsewhere, so that lanes and doubles do not meet the apex by themselves.
  const auto block = [](Vector size, Vector at) { return transformed(box(size), translation(at)); };
  const Solid solid = unite({cone, block({12, 10, 1}, {-6, -4.35, -1}), block({12, 6, 1.1}, {-6, 1.45, 0}),
                             block({0.1, 0.1, 0.1}, {4, 3, 3})});
  const Scene scene = compile(solid);
  Caster exact(scene, exact_predicates());
  Caster certified(scene);
  const auto list_of = [](Caster& caster, const Ray& ray) {
    IntervalList list;
    caster.begin(ray);
    caster.intervals(list, Span::line());
    return list;
  };
  const std::vector<Ray> rays{Ray({-1.35, 6, -22.35}, {0, -4, 16}), Ray({2.65, 0, 9.65}, {-4, 0, -8}),
                              Ray({2.6500000000000004, -2, 7.65}, {-8, 4, -12}), Ray({-1.35, -5, 21.65}, {0, 4, -16})};
  for (const Ray& ray : rays) check_same(list_of(certified, ray), list_of(exact, ray));
}

TEST_CASE("lanes know what quadrics about an axis do, grazed and along their sides, too") {
  RandomSolids random(31);
  for (const Vector direction : {Vector{0, 0, 1}, Vector{1, 0, 0}, Vector{0, 1, 0}}) {
    const Transform turn = direction.z != 0   ? Transform()
                           : direction.x != 0 ? rotation(90, {0, 1, 0})
                                              : rotation(90, {1, 0, 0});
    std::vector<Solid> solids{transformed(cylinder(0.5, 0.4, 0.1), translation({-0.7, 0, -0.2})),
                              transformed(ellipsoid({0.3, 0.3, 0.6}), translation({0.6, 0.5, 0})),
                              transformed(hyperboloid(1, 0.4, 0.1), translation({0.6, -0.5, 0.1})),
                              transformed(ellipsoid({0.25, 0.25, 0.02}), translation({-0.5, 0.7, 0.3}))};
    const Solid solid = transformed(unite(solids), turn);
    const Scene scene = compile(solid);
    const Cells cells(scene);
    std::vector<Ray> rays = rays_at(random, 2000);
    // Along the sides of the cone, and close to its apex.
    const Point apex{-0.7, 0, -0.2 + 0.5 * 0.4 / 0.3};
    for (int i = 0; i < 200; ++i) {
      const double angle = 0.03 * i;
      const Vector side{0.3 * std::cos(angle), 0.3 * std::sin(angle), -0.5};
      const double off = std::ldexp(1.0, -i % 60);
      rays.emplace_back(apex - 3.0 * side + Vector{off, 0, 0}, side);
      rays.emplace_back(apex + Vector{2, off, 0}, Vector{-1, 0.01 * off, 0});
    }
    const test::RayBatch batch(rays);
    for (const PacketCaster::Width width : {PacketCaster::Width::packet, PacketCaster::Width::single}) {
      for (const std::string_view set : PacketCaster::instruction_sets()) {
        PacketCaster caster(cells, width, set);
        check_lists(cells, caster, batch.arrays(), batch);
        CHECK(caster.left_to_caster().size() < rays.size() / 10);
      }
    }
  }
}

TEST_CASE("rays from where the scene is a point, and all but along an axis, are answered exactly") {
  const Point far{1.4448509344704208, 1.4677759655495504, 0.22754620094568545};
  for (const double r : {1e-12, 1e-18, 1e-24, 1e-40}) {
    check_line(sphere(r), Ray(far, Point{} - far));
    check_line(box({r, r, r}, Centering::centered), Ray(far, Point{} - far));
  }
  for (const double tiny : {1e-323, 1e-300, 1e-120}) {
    check_line(box({1, 1, 1}), Ray({-3, 0, 0}, {1, -tiny, tiny}));
    check_line(box({1, 1, 1}), Ray({-3, 1, 1}, {1, tiny, -tiny}));
    check_line(box({1, 1, 1}), Ray({-3, 1, 1}, {0x1p390, tiny, -tiny}));
    check_line(box({1, 1, 1}), Ray({-3, 0, 0}, {0x1p-390, -0x1p-390 * tiny, 0}));
  }
}
