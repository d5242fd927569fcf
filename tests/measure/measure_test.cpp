// SPDX-License-Identifier: MIT
#include "measure/measure.h"

#include <tbb/task_arena.h>

#include <cmath>

#include "csg/base/error.h"
#include "csg/solid/primitives.h"
#include "raycast/ray/caster.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using test::RandomSolids;

namespace {

Solid shifted(Solid solid, Vector by) { return transformed(std::move(solid), translation(by)); }
Solid part(const char* name, double density, Solid solid) { return named(std::move(solid), {name, density}); }

Measures measured(const Solid& solid, MeasureOptions options = {}) {
  const Scene scene = compile(solid);
  return measure(scene, scene.root(), 1, options);
}

bool holds(Measured m, double truth) { return std::fabs(m.value - truth) <= m.error + 1e-15 * std::fabs(truth); }

}  // namespace

TEST_CASE("The empty solid has zeros, and no centroid") {
  for (const Solid& solid : {Solid(), sphere(1) & shifted(sphere(1), {5, 0, 0})}) {
    const Measures m = measured(solid);
    CHECK(m.is_bounded);
    CHECK(m.is_as_asked);
    CHECK(m.volume.value == 0);
    CHECK(m.volume.error == 0);
    CHECK(m.area.value == 0);
    CHECK(std::isnan(m.centroid.x));
    CHECK(m.bounds.is_null());
  }
}

TEST_CASE("Of a solid that may be unbounded nothing is measured, and that is said") {
  for (const Solid& solid : {Solid::everything(), complement(sphere(1)), halfspace({0, 0, 1}, 0)}) {
    const Measures m = measured(solid);
    CHECK_FALSE(m.is_bounded);
    CHECK_FALSE(m.is_as_asked);
    CHECK(std::isinf(m.volume.value));
    CHECK(std::isinf(m.volume.error));
  }
}

TEST_CASE("Two solids that only touch make none: the volume is 0 within its error, and no cutting goes on for ever") {
  const Measures m = measured(sphere(1) & shifted(sphere(1), {2, 0, 0}));
  CHECK(holds(m.volume, 0));
  CHECK(m.volume.error < 1e-9);
  CHECK(m.pieces < 200000);
}

TEST_CASE("Bounds are those of what is left, not of what it was made from") {
  const Measures m = measured((box({4, 4, 4}, Centering::centered) & sphere(1)) - halfspace({0, 0, 1}, 0.5));
  CHECK(m.bounds_error < 1e-8);
  CHECK(m.bounds.upper.z == Approx(1).margin(1e-8));
  CHECK(m.bounds.lower.z == Approx(0.5).margin(1e-8));
  CHECK(m.bounds.upper.x == Approx(std::sqrt(0.75)).margin(1e-8));
  CHECK(m.bounds.lower.y == Approx(-std::sqrt(0.75)).margin(1e-8));
}

TEST_CASE("A plate too thin for anybody to find a point in it has bounds all the same") {
  const Measures m = measured(box({1, 1, 1e-15}));
  REQUIRE_FALSE(m.bounds.is_null());
  CHECK(m.bounds.lower.x <= 0);
  CHECK(m.bounds.upper.x >= 1);
  CHECK(m.bounds_error < 2);
  CHECK(holds(m.volume, 1e-15));
}

TEST_CASE("Bounds of random solids hold what rays and points find in them") {
  RandomSolids random(3);
  for (int round = 0; round < test::times(60); ++round) {
    const Scene scene = compile(random.tree(1 + round % 6));
    const Measures m = measure(scene, scene.root(), 1);
    if (!m.is_bounded) continue;
    Caster caster(scene);
    for (int i = 0; i < 400; ++i) {
      const Point p = random.point(3);
      if (caster.locate(p) != Location::inside) continue;
      INFO("round " << round);
      REQUIRE_FALSE(m.bounds.is_null());
      CHECK(m.bounds.contains(p));
    }
  }
}

TEST_CASE("Parts count with their densities, and where they overlap the first has the place") {
  const Scene scene = compile(unite({part("a", 2, box({2, 1, 1})), part("b", 10, shifted(box({2, 1, 1}), {1, 0, 0})),
                                     shifted(box({1, 1, 1}), {4, 0, 0}), shifted(box({1, 1, 1}), {0.5, 0, 0})}));
  const SceneMeasures measures = measure(scene);
  REQUIRE(measures.parts.size() == 2);
  CHECK(holds(measures.parts[0].mass, 4));
  CHECK(holds(measures.parts[1].mass, 20));
  CHECK(holds(measures.parts[1].volume, 2));
  CHECK(holds(measures.whole.volume, 4));
  // [0, 2] of density 2, [2, 3] of 10, [4, 5] of 1.
  CHECK(holds(measures.whole.mass, 4 + 10 + 1));
  CHECK(std::fabs(measures.whole.centroid.x - (4 * 1 + 10 * 2.5 + 4.5) / 15) <= measures.whole.centroid_error + 1e-15);
  const double across = 15 / 12.0 + 15 / 12.0;
  CHECK(std::fabs(measures.whole.inertia[0] - across) <= measures.whole.inertia_error + 1e-15);
}

TEST_CASE("Without parts mass is volume") {
  const Scene scene = compile(sphere(1));
  const Measures m = measure(scene).whole;
  CHECK(m.mass.value == m.volume.value);
  const Measures heavy = measure(scene, scene.root(), 7.5);
  CHECK(heavy.mass.value == Approx(7.5 * m.volume.value).epsilon(1e-14));
  CHECK(heavy.inertia[0] == Approx(7.5 * m.inertia[0]).epsilon(1e-13));
}

TEST_CASE("The answer does not depend on the number of threads") {
  RandomSolids random(21);
  for (int round = 0; round < test::times(10); ++round) {
    const Scene scene = compile(random.tree(5));
    const auto on_threads = [&](int threads) {
      tbb::task_arena arena(threads);
      return arena.execute([&] { return measure(scene, scene.root(), 1); });
    };
    const Measures one = on_threads(1);
    const Measures two = on_threads(2);
    CHECK(one.pieces == two.pieces);
    CHECK((one.volume.value == two.volume.value || std::isinf(one.volume.value)));
    CHECK((one.area.error == two.area.error || std::isinf(one.area.error)));
    CHECK((one.inertia == two.inertia || !one.is_bounded || std::isnan(one.centroid.x)));
  }
}

TEST_CASE("Smaller errors that are asked for are kept, and hold each other") {
  RandomSolids random(8);
  for (int round = 0; round < test::times(30); ++round) {
    const Solid solid = random.tree(1 + round % 5);
    MeasureOptions options;
    options.relative_area_error = 0.5;
    options.relative_error = 1e-3;
    const Measures rough = measured(solid, options);
    options.relative_error = 1e-7;
    const Measures fine = measured(solid, options);
    if (!rough.is_bounded) continue;
    INFO("round " << round);
    CHECK(std::fabs(rough.volume.value - fine.volume.value) <= rough.volume.error + fine.volume.error);
    CHECK(std::fabs(rough.area.value - fine.area.value) <= rough.area.error + fine.area.error);
    if (fine.is_as_asked && fine.volume.value > 0) CHECK(fine.volume.error <= 1e-7 * fine.volume.value);
  }
}

TEST_CASE("With few pieces allowed bounds are wide, hold, and it is said") {
  MeasureOptions options;
  options.relative_error = 1e-9;
  options.most_pieces = 100;
  const Measures m = measured(sphere(1) - cylinder(4, 0.5, 0.5, Centering::centered), options);
  CHECK_FALSE(m.is_as_asked);
  CHECK(m.pieces <= 100);
  CHECK(holds(m.volume, 4.0 / 3 * M_PI * std::pow(0.75, 1.5)));
}

TEST_CASE("Whoever asks may have enough before the end") {
  MeasureOptions options;
  options.relative_error = 1e-9;
  double last = 0;
  options.is_enough = [&](double error) {
    last = error;
    return error <= 1e-3;
  };
  const Measures m = measured(sphere(1), options);
  CHECK_FALSE(m.is_as_asked);
  CHECK(last <= 1e-3);
  CHECK(holds(m.volume, 4.0 / 3 * M_PI));
}

TEST_CASE("Far from the origin and in small and large units errors stay what they are beside the solid") {
  for (const double size : {1e-9, 1.0, 1e9}) {
    for (const double away : {0.0, 1e3, 1e6}) {
      const Measures m = measured(transformed(sphere(size), translation({away * size, -away * size, 0})));
      INFO(size << " at " << away);
      CHECK(m.is_as_asked);
      CHECK(holds(m.volume, 4.0 / 3 * M_PI * size * size * size));
      CHECK(std::fabs(m.centroid.x - away * size) <= m.centroid_error);
      CHECK(m.centroid_error < 1e-3 * size);
    }
  }
}

TEST_CASE("What makes no sense is refused") {
  const Scene scene = compile(sphere(1));
  MeasureOptions options;
  options.relative_error = 0;
  CHECK_THROWS_AS(measure(scene, options), Error);
  CHECK_THROWS_AS(measure(scene, scene.root(), -1), Error);
  CHECK_THROWS_AS(measure(scene, scene.root(), NAN), Error);
}

TEST_CASE("Where nothing is known yet errors are infinite, not missing") {
  MeasureOptions options;
  options.most_pieces = 1;
  const Measures m = measured(sphere(1), options);
  CHECK_FALSE(m.is_as_asked);
  CHECK(std::isinf(m.inertia_error));
  CHECK(std::isinf(m.centroid_error));
  CHECK(holds(m.volume, 4.0 / 3 * M_PI));
}

TEST_CASE("What is too small or too large for doubles is within the error all the same") {
  const Measures tiny = measured(sphere(1e-110));
  CHECK(tiny.volume.error > 0);
  const Measures huge = measured(sphere(1e110));
  CHECK(std::isinf(huge.volume.error));
  CHECK(std::isfinite(huge.area.value));
}
