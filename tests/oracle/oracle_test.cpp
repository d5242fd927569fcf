// SPDX-License-Identifier: MIT
// The oracle under test: what it must notice.
#include "tests/oracle/building.h"
#include "tests/oracle/check.h"
#include "tests/oracle/polyhedra.h"
#include "tests/support/catch.h"

namespace csgcast::oracle {
namespace {

constexpr Workload small_work{500, 50};

Tally tally_of(const Model& model) {
  return check_family([&model](test::RandomSolids&) { return model; }, 1, small_work);
}

std::vector<PlaneEquation> planes_of_cube() {
  return {{{1, 0, 0}, 1}, {{-1, 0, 0}, 1}, {{0, 1, 0}, 1}, {{0, -1, 0}, 1}, {{0, 0, 1}, 1}, {{0, 0, -1}, 1}};
}

TEST_CASE("the oracle notices a corner that is an ulp off") {
  test::RandomSolids random(7);
  test::PointCloud points = test::sphere_points(random, 10);
  Model model = single(hull_part(points));
  CHECK(tally_of(model).wrong == 0);
  points[3].x = test::ulps_off(points[3].x, 1);
  model.solid = convex_from_points(points);
  CHECK(tally_of(model).wrong > 0);
}

TEST_CASE("the oracle notices the wrong operation on solids with a common face") {
  Part right = box_part({1, 1, 1}, Centering::corner);
  right.move(translation({1, 0, 0}));
  const std::vector<Part> parts{box_part({1, 1, 1}, Centering::corner), right};
  Model model = combination(Operation::unite, parts);
  CHECK(tally_of(model).wrong == 0);
  model.operation = Operation::intersect;
  CHECK(tally_of(model).wrong > 0);
}

TEST_CASE("the oracle notices a plane too many that changes no point") {
  std::vector<PlaneEquation> planes = planes_of_cube();
  Model model = single(planes_part(planes));
  CHECK(tally_of(model).wrong == 0);
  planes.push_back({{1, 1, 1}, 4});
  model.solid = convex_from_planes(planes);
  CHECK(tally_of(model).wrong > 0);
}

TEST_CASE("hulls are empty exactly where CGAL finds all points in one plane") {
  test::RandomSolids random(11);
  int flat = 0;
  for (int i = 0; i < 500; ++i) {
    const test::PointCloud points = test::lattice_points(random, 3 + i % 5);
    std::vector<RationalPoint> exact_points;
    for (const Point& p : points) exact_points.push_back(exact(p));
    const bool is_flat = !Polyhedron::hull(exact_points);
    CHECK((convex_from_points(points).kind() == Solid::Kind::empty) == is_flat);
    flat += is_flat ? 1 : 0;
  }
  CHECK(flat > 50);
  CHECK(flat < 450);
}

}  // namespace
}  // namespace csgcast::oracle
