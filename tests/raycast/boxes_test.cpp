// SPDX-License-Identifier: MIT
#include <vector>

#include "csg/base/transform.h"
#include "csg/solid/primitives.h"
#include "raycast/cells/cells.h"
#include "raycast/packets/packet_caster.h"
#include "tests/support/at.h"
#include "tests/support/batches.h"
#include "tests/support/catch.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using test::at;
using test::check_lists;
using test::DepartingRays;
using test::RandomSolids;
using test::RayBatch;
using test::rays_at;

namespace {

// Small solids all over the cube of side 2: balls, ellipsoids, lenses, rods, bricks.
std::vector<Solid> crumbs(RandomSolids& random, std::size_t count, double size) {
  std::vector<Solid> result;
  for (std::size_t i = 0; i < count; ++i) {
    const Point place = random.point(1);
    const double r = size * random.number(0.5, 1);
    Solid solid = sphere(r);
    if (i % 4 == 1) solid = ellipsoid({r, 0.7 * r, 0.4 * r});
    if (i % 4 == 2) solid = at(sphere(r), {0.4 * r, 0, 0}) & at(sphere(r), {-0.4 * r, 0, 0});
    if (i % 16 == 3) solid = cylinder(2 * r, 0.3 * r, 0.3 * r, Centering::centered);
    if (i % 16 == 7) solid = box({r, 0.5 * r, 2 * r}, Centering::centered);
    result.push_back(at(solid, place - Point{}));
  }
  return result;
}

Solid die(Solid holes) { return box({2, 2, 2}, Centering::centered) - std::move(holes); }

// Whatever is asked of it, in packets and ray by ray, by each instruction set.
void check_all(const Scene& scene, std::uint64_t seed) {
  RandomSolids random(seed);
  const Cells cells(scene);
  REQUIRE(cells.counts().boxed > 0);
  const RayBatch rays(rays_at(random, 300));
  const DepartingRays departing(scene, random, rays.list());
  REQUIRE(departing.rays.size() > 20);
  std::vector<double> ends;
  for (std::size_t i = 0; i < rays.size(); ++i) ends.push_back(random.number(0, 3));
  const auto check_caster = [&](PacketCaster caster) {
    RayArrays asked = rays.arrays();
    check_lists(cells, caster, asked, rays);
    CHECK(caster.left_to_caster().size() < rays.size() / 10);
    asked.whole_line = true;
    check_lists(cells, caster, asked, rays);
    asked.end = ends;
    check_lists(cells, caster, asked, rays);
    asked.whole_line = false;
    check_lists(cells, caster, asked, rays);
    check_lists(cells, caster, departing.arrays(), departing.rays);
  };
  for (const PacketCaster::Width width : {PacketCaster::Width::packet, PacketCaster::Width::single}) {
    for (const std::string_view set : PacketCaster::instruction_sets()) {
      CAPTURE(set);
      check_caster(PacketCaster(cells, width, set));
    }
  }
}

std::size_t nodes_of_a_list(const Cells& cells, const Ray& ray) {
  PacketCaster caster(cells);
  IntervalBatch batch;
  const std::vector<Ray> rays(8, ray);
  caster.intervals(rays, batch);
  return caster.counts().nodes;
}

}  // namespace

TEST_CASE("lists by boxes of unions, and of what is left between holes, are the scalar caster's") {
  RandomSolids random(21);
  check_all(compile(unite(crumbs(random, 200, 0.1))), 1);
  check_all(compile(die(unite(crumbs(random, 200, 0.1)))), 2);
  check_all(compile(transformed(die(unite(crumbs(random, 80, 0.15))), rotation(35, {1, 2, 3}))), 3);
}

TEST_CASE("an unbounded solid that turned boxes leave open cuts lists all the same") {
  RandomSolids random(26);
  std::vector<Solid> holes = crumbs(random, 200, 0.1);
  holes.push_back(halfspace({1, 2, 5}, -6));
  check_all(compile(transformed(die(unite(holes)), rotation(35, {1, 2, 3}))), 6);
}

TEST_CASE("solids in boxes that share surfaces are the scalar caster's") {
  // Layers of voids that end in the same planes, and of caps of balls, cut by these, that stand on each other.
  std::vector<Solid> voids;
  std::vector<Solid> caps;
  for (int k = 0; k < 6; ++k) {
    const Vector layer{0, 0, -0.9 + 0.3 * k};
    const Solid above = at(box({4, 4, 4}, Centering::centered), layer + Vector{0, 0, 2});
    const Solid below = at(box({4, 4, 4}, Centering::centered), layer + Vector{0, 0, -2});
    for (int i = 0; i < 8; ++i) {
      for (int j = 0; j < 8; ++j) {
        const Vector place = layer + Vector{-0.9 + 0.25 * i, -0.9 + 0.25 * j, 0};
        voids.push_back(at(cylinder(0.25, 0.03, 0.03), place));
        caps.push_back(at(sphere(0.05), place) & (j % 2 == 0 ? above : below));
        if (i % 4 == 0) caps.push_back(at(sphere(0.03), place) & (j % 2 == 0 ? below : above));
      }
    }
  }
  check_all(compile(die(unite(voids))), 4);
  check_all(compile(unite(caps)), 5);
}

TEST_CASE("events that tie along lines among balls and bricks are the scalar caster's") {
  // Balls that touch, bricks between them that begin and end where balls do, and lines through rows of them.
  std::vector<Solid> crowd;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      for (int k = 0; k < 6; ++k) {
        const Vector place{-0.625 + 0.25 * i, -0.625 + 0.25 * j, -0.625 + 0.25 * k};
        const bool is_ball = (i + j + k) % 3 != 0;
        crowd.push_back(at(is_ball ? sphere(0.125) : box({0.25, 0.125, 0.0625}, Centering::centered), place));
      }
    }
  }
  std::vector<Ray> list;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      const double y = -0.625 + 0.25 * i, z = -0.625 + 0.25 * j;
      for (const double off : {0.0, 0x1p-40, 0x1p-30, 0x1p-4}) {
        list.emplace_back(Point{-3, y + off, z}, Vector{1, 0, 0});
        list.emplace_back(Point{y, 3, z - off}, Vector{0, -1, 0});
        list.emplace_back(Point{y + 2, z + 2, -2.625 - off}, Vector{-1, -1, 1});
      }
    }
  }
  const RayBatch rays(list);
  for (const Solid& solid : {unite(crowd), die(unite(crowd))}) {
    const Scene scene = compile(solid);
    const Cells cells(scene);
    REQUIRE(cells.counts().boxed > 0);
    for (const std::string_view set : PacketCaster::instruction_sets()) {
      CAPTURE(set);
      PacketCaster caster(cells, PacketCaster::Width::single, set);
      check_lists(cells, caster, rays.arrays(), rays);
    }
  }
}

TEST_CASE("a face by boxes is its owner's where an intersection without a thickness has the surface as well") {
  RandomSolids random(27);
  // The two touch: flipped in one of them alone, their common face makes a hole. By the rule it is the first one's.
  const Solid left = at(box({0.1, 0.1, 0.1}), {0.1, 0, 0});
  const Solid right = at(box({0.1, 0.1, 0.1}), {0.2, 0, 0});
  std::vector<Solid> holes{left & right, at(box({0.3, 0.1, 0.1}), {0.2, 0, 0})};
  for (Solid& crumb : crumbs(random, 200, 0.1)) holes.push_back(std::move(crumb));
  const Scene scene = compile(die(unite(holes)));
  const Cells cells(scene);
  REQUIRE(cells.counts().boxed > 0);
  std::vector<Ray> list;
  for (int i = 0; i < 64; ++i) list.emplace_back(Point{3, 0.001 * i + 0.01, 0.05}, Vector{-1, 0.0001 * i, 0.001});
  const RayBatch rays(list);
  for (const PacketCaster::Width width : {PacketCaster::Width::packet, PacketCaster::Width::single}) {
    PacketCaster caster(cells, width);
    check_lists(cells, caster, rays.arrays(), rays);
  }
}

TEST_CASE("a segment within a solid meets no surface, and is inside all the same") {
  RandomSolids random(23);
  const Scene scene = compile(die(unite(crumbs(random, 100, 0.05))));
  const Cells cells(scene);
  REQUIRE(cells.counts().boxed > 0);
  const RayBatch rays(std::vector<Ray>(8, Ray({0.999, 0.999, 0.999}, {-1, -1, -1})));
  const std::vector<double> ends(8, 1e-4);
  RayArrays asked = rays.arrays();
  asked.end = ends;
  PacketCaster caster(cells);
  check_lists(cells, caster, asked, rays);
  IntervalBatch batch;
  caster.intervals(asked, batch);
  CHECK(batch.intervals.size() == 8);
  CHECK(caster.left_to_caster().empty());
}

TEST_CASE("lines that meet too many boxes go through cells") {
  RandomSolids random(24);
  std::vector<Solid> solids = crumbs(random, 3000, 0.02);
  for (int i = 0; i < 100; ++i) solids.push_back(at(sphere(0.005), {-0.99 + 0.0198 * i, 0.4, 0.3}));
  const Scene scene = compile(unite(solids));
  const Cells cells(scene);
  REQUIRE(cells.counts().boxed > 3000);
  const Ray along({-3, 0.4, 0.3}, {1, 1e-5, 1e-5});
  const Ray beside({-3, 0.45, 0.3}, {1, 1e-5, 1e-5});
  CHECK(nodes_of_a_list(cells, along) > 100);
  CHECK(nodes_of_a_list(cells, beside) < 100);
  std::vector<Ray> list;
  for (int i = 0; i < 64; ++i) list.emplace_back(Point{-3, 0.4 + 0.0001 * i, 0.3}, Vector{1, 1e-5, 1e-5});
  const RayBatch rays(list);
  for (const PacketCaster::Width width : {PacketCaster::Width::packet, PacketCaster::Width::single}) {
    PacketCaster caster(cells, width);
    check_lists(cells, caster, rays.arrays(), rays);
  }
}

TEST_CASE("boxes are kept where they pay only") {
  RandomSolids random(25);
  const auto boxed = [](const Solid& solid) { return Cells(compile(solid)).counts().boxed; };
  CHECK(boxed(unite(crumbs(random, 5, 0.1))) == 0);                                    // too few
  CHECK(boxed(unite(crumbs(random, 60, 0.9))) == 0);                                   // a line meets most of them
  CHECK(boxed(complement(unite(crumbs(random, 60, 0.1)))) == 0);                       // unbounded
  CHECK(boxed(unite(crumbs(random, 60, 0.1)) & unite(crumbs(random, 60, 0.1))) == 0);  // not a union less others
}
