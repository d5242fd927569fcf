// SPDX-License-Identifier: MIT
#include "measure/thickness.h"

#include <tbb/task_arena.h>

#include <cmath>

#include "csg/solid/primitives.h"
#include "raycast/scene/scene.h"
#include "tests/support/catch.h"

using namespace csgcast;

namespace {

std::optional<ThinPlace> thinnest(const Solid& solid, std::size_t samples = 64) {
  const Scene scene = compile(solid);
  const Cells cells(scene);
  return find_thinnest(cells, samples);
}

Solid shifted(Solid solid, Vector by) { return transformed(std::move(solid), translation(by)); }

}  // namespace

TEST_CASE("The thinnest place of a plate, a tube, a shell and a plate with a thin web") {
  CHECK(thinnest(box({4, 3, 0.25}))->thickness == Approx(0.25).epsilon(1e-14));
  const Solid tube = cylinder(2, 1, 1, Centering::centered) - cylinder(4, 0.9, 0.9, Centering::centered);
  CHECK(thinnest(tube)->thickness == Approx(0.1).epsilon(1e-12));
  CHECK(thinnest(sphere(1) - sphere(0.75))->thickness == Approx(0.25).epsilon(1e-12));
  const auto web = thinnest(box({4, 4, 1}) - shifted(cylinder(2, 0.5, 0.5), {2, 2, 0.125}));
  REQUIRE(web);
  CHECK(web->thickness == Approx(0.125).epsilon(1e-12));
  CHECK(std::hypot(web->place.x - 2, web->place.y - 2) < 0.5);
  CHECK(std::fabs(web->normal.z) == 1);
}

TEST_CASE("A corner is no thin wall") {
  const Solid wedge = box({2, 2, 2}) & halfspace({1, 0, 1}, 1);
  CHECK(thinnest(wedge)->thickness > 0.001);
  CHECK(thinnest(sphere(1))->thickness == Approx(2).epsilon(1e-12));
}

TEST_CASE("Empty and unbounded solids have no thinnest place") {
  CHECK_FALSE(thinnest(Solid()));
  CHECK_FALSE(thinnest(complement(sphere(1))));
}

TEST_CASE("The thinnest place does not depend on the number of threads") {
  const Scene scene = compile(sphere(1) - cylinder(4, 0.5, 0.5, Centering::centered) - box({1, 1, 1}));
  const Cells cells(scene);
  const auto on = [&](int threads) {
    return tbb::task_arena(threads).execute([&] { return find_thinnest(cells, 50); });
  };
  const auto one = on(1), two = on(2);
  REQUIRE(one);
  REQUIRE(two);
  CHECK(one->thickness == two->thickness);
  CHECK(one->place == two->place);
}

TEST_CASE("At the first face of rays: thickness, nothing where they miss, infinity where nothing ends the solid") {
  const Scene scene =
      compile(sphere(1) + shifted(box({1, 1, 9}), {5, 0, 0}) + (halfspace({0, 0, 1}, -3) & halfspace({1, 0, 0}, -5)));
  const Cells cells(scene);
  ThicknessProbe probe(cells);
  const double ox[] = {0, 0.6, 3, 5.5, -9}, oy[] = {0, 0, 0, 0.5, 0}, oz[] = {9, 9, 9, 19, 9};
  const double dx[] = {0, 0, 0, 0, 0}, dz[] = {-1, -1, -1, -1, -1};
  RayArrays rays;
  rays.origin[0] = ox;
  rays.origin[1] = oy;
  rays.origin[2] = oz;
  rays.direction[0] = rays.direction[1] = dx;
  rays.direction[2] = dz;
  double thickness[5];
  probe.first_faces(rays, thickness);
  CHECK(thickness[0] == Approx(2));
  CHECK(thickness[1] == Approx(2));
  CHECK(thickness[2] == 0);
  CHECK(thickness[3] == Approx(9));
  CHECK(std::isinf(thickness[4]));
}
