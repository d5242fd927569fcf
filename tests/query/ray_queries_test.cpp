// SPDX-License-Identifier: MIT
#include "query/ray_queries.h"

#include <tbb/task_arena.h>

#include <cmath>
#include <limits>
#include <thread>

#include "csg/base/error.h"
#include "csg/solid/primitives.h"
#include "tests/support/catch.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using test::RandomSolids;

namespace {

struct Numbers {
  std::vector<double> origins, directions;

  void add(Point o, Vector d) {
    origins.insert(origins.end(), {o.x, o.y, o.z});
    directions.insert(directions.end(), {d.x, d.y, d.z});
  }
  Rays rays() const { return {origins, directions}; }
  Ray ray(std::size_t i) const {
    return Ray({origins[3 * i], origins[3 * i + 1], origins[3 * i + 2]},
               {directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]});
  }
};

Numbers random_rays(RandomSolids& random, std::size_t count) {
  Numbers numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.add(random.point(3), random.direction());
  return numbers;
}

Solid plate_with_parts() {
  const Solid plate = named(box({4, 4, 1}, Centering::centered) - cylinder(4, 1, 1, Centering::centered), {"plate", 1});
  return plate + named(transformed(sphere(0.5), translation({0, 0, 0})), {"ball", 2});
}

// What a Caster says of each ray, in order.
void check_as_caster(const RayQueries& model, const Numbers& numbers, const QueryOptions& options) {
  const IntervalTable table = model.intervals(numbers.rays(), options);
  REQUIRE(table.offsets.size() == numbers.rays().count() + 1);
  REQUIRE(table.offsets.front() == 0);
  REQUIRE(table.offsets.back() == table.count());
  Caster caster(model.scene());
  IntervalList list;
  for (std::size_t i = 0; i < numbers.rays().count(); ++i) {
    caster.begin(numbers.ray(i));
    caster.intervals(list, options.span);
    REQUIRE(table.offsets[i + 1] - table.offsets[i] == list.size());
    for (std::size_t k = 0; k < list.size(); ++k) {
      const std::size_t at = 2 * (table.offsets[i] + k);
      CHECK(table.t[at] == list[k].entry.t);
      CHECK(table.t[at + 1] == list[k].exit.t);
      CHECK(table.surfaces[at] == list[k].entry.surface.index());
      CHECK(table.surfaces[at + 1] == list[k].exit.surface.index());
      for (std::size_t end = 0; end < 2; ++end) {
        const Crossing& crossing = end == 0 ? list[k].entry : list[k].exit;
        const bool has_face = crossing.surface.valid();
        EndFace face;
        if (has_face) face = end_face(caster.attribute({crossing, end == 0 ? Passage::entry : Passage::exit}));
        if (options.faces) {
          CHECK(table.leaves[at + end] == face.leaf.index());
          CHECK(table.parts[at + end] == (has_face ? model.scene().leaf(face.leaf).part.index() : no_id));
        }
        for (std::size_t axis = 0; options.normals && axis < 3; ++axis)
          CHECK(table.normals[3 * (at + end) + axis] == (has_face ? face.normal[axis] : 0));
      }
    }
  }
}

}  // namespace

TEST_CASE("A table of intervals is what a caster says ray by ray, with faces and normals") {
  RandomSolids random(31);
  const RayQueries model(plate_with_parts());
  const Numbers numbers = random_rays(random, 9000);
  QueryOptions options;
  check_as_caster(model, numbers, options);
  options.faces = options.normals = true;
  check_as_caster(model, numbers, options);
}

TEST_CASE("Tables of lines, of ends cut off, and of spans from anywhere are what a caster says") {
  RandomSolids random(32);
  const RayQueries model(plate_with_parts());
  const Numbers numbers = random_rays(random, 2000);
  for (const Span span : {Span::line(), Span{0, 2}, Span{1, 2}, Span{-1, 5}, Span{-HUGE_VAL, 1.5}}) {
    QueryOptions options;
    options.span = span;
    options.faces = options.normals = true;
    check_as_caster(model, numbers, options);
  }
}

TEST_CASE("First and any hits are those of a caster") {
  RandomSolids random(33);
  const RayQueries model(plate_with_parts());
  const Numbers numbers = random_rays(random, 5000);
  for (const Span span : {Span{}, Span{0, 2}, Span{1, 3}}) {
    QueryOptions options;
    options.span = span;
    const HitTable hits = model.first_hits(numbers.rays(), options);
    const std::vector<std::uint8_t> any = model.any_hits(numbers.rays(), options);
    Caster caster(model.scene());
    for (std::size_t i = 0; i < numbers.rays().count(); ++i) {
      caster.begin(numbers.ray(i));
      const std::optional<Hit> hit = caster.first_hit(span);
      CHECK(hits.t[i] == (hit ? hit->crossing.t : HUGE_VAL));
      CHECK(hits.surfaces[i] == (hit ? hit->crossing.surface.index() : no_id));
      CHECK((hits.is_entry[i] != 0) == (hit && hit->passage == Passage::entry));
      CHECK((any[i] != 0) == caster.any_hit(span));
    }
  }
}

TEST_CASE("Points are located as by a caster") {
  RandomSolids random(34);
  const RayQueries model(plate_with_parts());
  std::vector<double> points;
  for (int i = 0; i < 3000; ++i) {
    for (int axis = 0; axis < 3; ++axis) points.push_back(random.quarter(-2, 2));
  }
  const std::vector<Location> locations = model.locate(points);
  Caster caster(model.scene());
  for (std::size_t i = 0; i < locations.size(); ++i)
    CHECK(locations[i] == caster.locate({points[3 * i], points[3 * i + 1], points[3 * i + 2]}));
}

TEST_CASE("Any number of threads gives the same table, and many threads may ask one model at once") {
  RandomSolids random(35);
  const RayQueries model(plate_with_parts());
  const Numbers numbers = random_rays(random, 20000);
  const IntervalTable one = tbb::task_arena(1).execute([&] { return model.intervals(numbers.rays()); });
  std::vector<std::thread> threads;
  std::array<bool, 4> same{};
  for (std::size_t k = 0; k < same.size(); ++k) {
    threads.emplace_back([&, k] {
      const IntervalTable other = model.intervals(numbers.rays());
      same[k] = other.offsets == one.offsets && other.t == one.t && other.surfaces == one.surfaces;
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const bool is_same : same) CHECK(is_same);
}

TEST_CASE("No rays, an empty solid, everything: tables of the right sizes") {
  const Numbers none;
  Numbers one;
  one.add({0, 0, -5}, {0, 0, 2});
  const RayQueries empty{Solid()};
  CHECK(empty.intervals(none.rays()).offsets == std::vector<std::uint64_t>{0});
  CHECK(empty.intervals(one.rays()).offsets == std::vector<std::uint64_t>{0, 0});
  CHECK(std::isinf(empty.first_hits(one.rays()).t[0]));
  const RayQueries everything(Solid::everything());
  const IntervalTable table = everything.intervals(one.rays());
  REQUIRE(table.count() == 1);
  CHECK(table.t == std::vector<double>{0, HUGE_VAL});
  CHECK(table.surfaces == std::vector<std::uint32_t>{no_id, no_id});
  const RayQueries ball(sphere(1));
  CHECK(ball.intervals(one.rays()).t == std::vector<double>{2, 3});
}

TEST_CASE("Rays that are none are refused by their number") {
  const RayQueries model(sphere(1));
  const auto message = [&](Point o, Vector d) -> std::string {
    Numbers numbers;
    for (int i = 0; i < 5000; ++i) numbers.add({0, 0, 0}, {0, 0, 1});
    numbers.add(o, d);
    try {
      model.intervals(numbers.rays());
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(message({0, 0, 0}, {0, 0, 0}).find("ray 5000") != std::string::npos);
  CHECK(message({nan, 0, 0}, {0, 0, 1}).find("ray 5000") != std::string::npos);
  CHECK(message({0, 0, 0}, {HUGE_VAL, 0, 1}).find("ray 5000") != std::string::npos);
  CHECK(message({1e200, 0, 0}, {0, 0, 1}).find("ray 5000") != std::string::npos);
  Numbers odd;
  odd.origins = {0, 0};
  odd.directions = {0, 0, 1};
  CHECK_THROWS_AS(model.intervals(odd.rays()), Error);
  odd.origins = {0, 0, 0, 0, 0, 0};
  CHECK_THROWS_AS(model.any_hits(odd.rays()), Error);
  QueryOptions backwards;
  backwards.span = {2, 1};
  odd.origins = {0, 0, 0};
  CHECK_THROWS_AS(model.intervals(odd.rays(), backwards), Error);
  CHECK_THROWS_AS(model.locate(std::vector<double>{0, 0, nan}), Error);
}

TEST_CASE("A query tells how far it is and can be ended") {
  RandomSolids random(36);
  const RayQueries model(sphere(1));
  const Numbers numbers = random_rays(random, 100000);
  QueryOptions options;
  double last = 0;
  bool ascends = true;
  options.progress = [&](const Progress& progress) {
    ascends = ascends && progress.share >= last && progress.share <= 1;
    last = progress.share;
    return true;
  };
  model.intervals(numbers.rays(), options);
  CHECK(ascends);
  CHECK(last == 1);
  options.progress = [](const Progress&) { return false; };
  CHECK_THROWS_AS(model.intervals(numbers.rays(), options), Cancelled);
}

TEST_CASE("A visitor sees intervals in order until it has enough") {
  const RayQueries model(sphere(1) + transformed(sphere(1), translation({5, 0, 0})));
  Caster caster(model.scene());
  IntervalList memory;
  std::vector<double> entries;
  const Ray ray({-5, 0, 0}, {1, 0, 0});
  RayQueries::visit_intervals(caster, ray, memory, [&](const Interval& interval) {
    entries.push_back(interval.entry.t);
    return true;
  });
  CHECK(entries == std::vector<double>{4, 9});
  int seen = 0;
  RayQueries::visit_intervals(caster, ray, memory, [&](const Interval&) { return ++seen < 1; });
  CHECK(seen == 1);
}
