// SPDX-License-Identifier: MIT
#include "csg/solid/primitives.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "csg/base/error.h"
#include "csg/solid/leaf_shape.h"
#include "tests/csg/membership.h"
#include "tests/support/catch.h"

using namespace csgcast;
using csgcast::testing::contains;
using Kind = Solid::Kind;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// -1 inside, 0 on a surface that passes there, 1 outside, of a leaf.
int side(const Solid& solid, Point p) {
  int result = -1;
  for (const QuadricForm& f : solid.shape().forms) result = std::max(result, f.at(p).sign());
  return result;
}

CanonicalForm surface(const Solid& solid, std::size_t index = 0) { return canonical(solid.shape().forms[index]); }

}  // namespace

TEST_CASE("a box holds its corners and nothing one unit in the last place beyond") {
  const Solid solid = box({1, 0.1, 3});
  CHECK(side(solid, {0.5, 0.05, 1.5}) == -1);
  CHECK(side(solid, {0, 0, 0}) == 0);
  CHECK(side(solid, {1, 0.1, 3}) == 0);
  CHECK(side(solid, {1, std::nextafter(0.1, 1), 3}) == 1);
  CHECK(side(solid, {0, 0, -5e-324}) == 1);
  CHECK(solid.shape().bounds == Box{{0, 0, 0}, {1, 0.1, 3}});
  CHECK(solid.shape().vertices.size() == 8);
  CHECK(solid.shape().is_convex_polyhedron);
}

TEST_CASE("a centred box is half its size in each direction, exactly, even where half is no double") {
  CHECK(box({1, 2, 3}, Centering::centered).shape().bounds == Box{{-0.5, -1, -1.5}, {0.5, 1, 1.5}});
  const double smallest = 5e-324;
  const Solid tiny = box({smallest, 1, 1}, Centering::centered);
  CHECK(side(tiny, {0, 0, 0}) == -1);
  CHECK(side(tiny, {smallest, 0, 0}) == 1);
  CHECK(tiny.shape().bounds.upper.x == smallest);
  CHECK(tiny.shape().vertices.empty());
}

TEST_CASE("balls and ellipsoids end exactly at their semi-axes") {
  CHECK(side(sphere(5), {3, 4, 0}) == 0);
  CHECK(side(sphere(0.1), {0.1, 0, 0}) == 0);
  CHECK(side(sphere(0.1), {0.1, 5e-324, 0}) == 1);
  const Solid solid = ellipsoid({0.1, 0.2, 0.3});
  CHECK(side(solid, {0.1, 0, 0}) == 0);
  CHECK(side(solid, {0, -0.2, 0}) == 0);
  CHECK(side(solid, {0, 0, std::nextafter(0.3, 1)}) == 1);
  CHECK(side(solid, {0, 0, std::nextafter(0.3, 0)}) == -1);
  CHECK(solid.shape().bounds == Box{{-0.1, -0.2, -0.3}, {0.1, 0.2, 0.3}});
}

TEST_CASE("a cone frustum has its radii exactly at its ends, from the corner and centred") {
  const double h = 0.7, r1 = 0.1, r2 = 0.3;
  const Solid standing = cylinder(h, r1, r2);
  CHECK(side(standing, {r1, 0, 0}) == 0);
  CHECK(side(standing, {0, r2, h}) == 0);
  CHECK(side(standing, {std::nextafter(r1, 1), 0, 0}) == 1);
  CHECK(side(standing, {0, std::nextafter(r2, 1), h}) == 1);
  const Solid centred = cylinder(h, r1, r2, Centering::centered);
  CHECK(side(centred, {-r1, 0, -h / 2}) == 0);
  CHECK(side(centred, {0, r2, h / 2}) == 0);
  CHECK(side(centred, {0, 0, std::nextafter(h / 2, 1)}) == 1);
  CHECK(contains(cylinder(2, 1, 0), {0.49, 0, 1}) == true);
  CHECK(contains(cylinder(2, 1, 0), {0.51, 0, 1}) == false);
  CHECK(side(cylinder(2, 0, 1), {0, 0, 0}) == 0);
}

TEST_CASE("cylinders of one radius share the surface whatever their height") {
  CHECK(surface(cylinder(1, 0.3, 0.3)).form == surface(cylinder(7, 0.3, 0.3, Centering::centered)).form);
  CHECK(surface(hyperboloid(5, 0.3, 0.3)).form == surface(cylinder(1, 0.3, 0.3)).form);
  CHECK(surface(sphere(2)).form == surface(ellipsoid({2, 2, 2})).form);
}

TEST_CASE("a paraboloid touches the origin and has its radius at its height") {
  const Solid solid = paraboloid(0.7, 0.3);
  CHECK(side(solid, {0, 0, 0}) == 0);
  CHECK(side(solid, {0.3, 0, 0.7}) == 0);
  CHECK(side(solid, {std::nextafter(0.3, 1), 0, 0.7}) == 1);
  CHECK(side(solid, {0, 0, 0.1}) == -1);
  CHECK(solid.shape().bounds == Box{{-0.3, -0.3, 0}, {0.3, 0.3, 0.7}});
}

TEST_CASE("a hyperboloid has its waist in the middle and its radius at both ends, waist narrower or wider") {
  for (const double waist : {0.0, 0.1, 0.3, 0.9}) {
    const Solid solid = hyperboloid(0.7, 0.3, waist);
    CAPTURE(waist);
    CHECK(side(solid, {waist, 0, 0}) == 0);
    CHECK(side(solid, {std::nextafter(waist, 2), 0, 0}) == 1);
    CHECK(side(solid, {0, 0.3, 0.35}) == 0);
    CHECK(side(solid, {0.3, 0, -0.35}) == 0);
    CHECK(side(solid, {0, std::nextafter(0.3, 1), 0.35}) == 1);
    CHECK(solid.shape().bounds.upper.x == std::fmax(0.3, waist));
  }
}

TEST_CASE("sizes without interior give the empty solid") {
  CHECK(box({0, 1, 1}).kind() == Kind::empty);
  CHECK(box({1, -1, 1}, Centering::centered).kind() == Kind::empty);
  CHECK(sphere(0).kind() == Kind::empty);
  CHECK(ellipsoid({1, 1, -1}).kind() == Kind::empty);
  CHECK(cylinder(0, 1, 1).kind() == Kind::empty);
  CHECK(cylinder(1, 0, 0).kind() == Kind::empty);
  CHECK(cylinder(1, -1, 2).kind() == Kind::empty);
  CHECK(paraboloid(1, 0).kind() == Kind::empty);
  CHECK(hyperboloid(1, 0, 0).kind() == Kind::empty);
  CHECK(hyperboloid(1, 1, -1).kind() == Kind::empty);
  CHECK(hyperboloid(1, 0, 1).kind() == Kind::leaf);
}

TEST_CASE("numbers that are not finite, and planes without a direction, are refused by name") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(box({1, infinity, 1}), Error);
  CHECK_THROWS_AS(sphere(nan), Error);
  CHECK_THROWS_AS(quadric({1, 1, nan, 0, 0, 0}, {}, 0), Error);
  CHECK_THROWS_AS(convex_from_points(std::vector<Point>{{0, 0, infinity}}), Error);
  try {
    halfspace({0, 0, 0}, 1);
    FAIL("a zero normal passed");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::bad_value);
    CHECK(std::string(error.what()).find("halfspace") != std::string::npos);
  }
}

TEST_CASE("a quadric without variables is all or nothing, and one of first degree a half-space") {
  CHECK(quadric({}, {}, 0).kind() == Kind::everything);
  CHECK(quadric({}, {}, -1).kind() == Kind::everything);
  CHECK(quadric({}, {}, 1).kind() == Kind::empty);
  const Solid plane = quadric({}, {0, 0, 2}, -6);
  CHECK(surface(plane).form == surface(halfspace({0, 0, 1}, 3)).form);
  CHECK(plane.shape().bounds == Box{{-infinity, -infinity, -infinity}, {infinity, infinity, 3}});
}

TEST_CASE("the off-diagonal entries of a quadric count twice") {
  const Solid solid = quadric({0, 0, 0, 1, 0, 0}, {}, -2);  // 2xy <= 2
  CHECK(side(solid, {1, 1, 9}) == 0);
  CHECK(side(solid, {1, 2, 0}) == 1);
  CHECK(side(solid, {-1, 2, 0}) == -1);
}

TEST_CASE("a quadric with no real point is the empty solid") {
  CHECK(quadric({1, 1, 1, 0, 0, 0}, {}, 1).kind() == Kind::empty);
  CHECK(quadric({1, 1, 0, 0, 0, 0}, {-2, 0, 0}, 1.5).kind() == Kind::empty);
  CHECK(quadric({1, 0, 0, 0, 0, 0}, {}, 1).kind() == Kind::empty);
  CHECK(quadric({1, 1, 1, 0, 0, 0}, {}, 0).kind() == Kind::leaf);  // one point
}

TEST_CASE("planes of a cube make the same surfaces as the cube, each once") {
  std::vector<PlaneEquation> planes;
  for (const double sign : {1.0, -1.0}) {
    planes.push_back({{sign, 0, 0}, 1});
    planes.push_back({{0, sign, 0}, 1});
    planes.push_back({{0, 0, 2 * sign}, 2});
    planes.push_back({{0, 0, sign}, 1});  // the same again
  }
  const Solid solid = convex_from_planes(planes);
  CHECK(solid.shape().forms.size() == 6);
  CHECK(solid.shape().bounds == Box{{-1, -1, -1}, {1, 1, 1}});
}

TEST_CASE("planes may leave a polyhedron unbounded, or no point at all") {
  const auto bounds_of = [](std::vector<PlaneEquation> planes) { return convex_from_planes(planes).shape().bounds; };
  CHECK(bounds_of({{{0, 0, 1}, 1}}) == Box{{-infinity, -infinity, -infinity}, {infinity, infinity, 1}});
  CHECK(bounds_of({{{1, 1, 0}, 1}, {{-1, -1, 0}, 1}}) == Box::everything());
  CHECK(bounds_of({{{1, 0, 0}, 3}, {{-1, 1, 0}, 0}, {{-1, -1, 0}, 0}}) == Box{{0, -3, -infinity}, {3, 3, infinity}});
  // A wedge with an angle of 1e-300: unbounded all the same.
  CHECK(bounds_of({{{1, -1e-300, 0}, 0}, {{-1, 0, 0}, 0}}).upper.x == infinity);
  const auto kind_of = [](std::vector<PlaneEquation> planes) { return convex_from_planes(planes).kind(); };
  CHECK(kind_of({{{1, 1, 1}, -1}, {{-1, -1, -1}, 0.5}}) == Kind::empty);
  CHECK(kind_of({{{1, 1, 1}, -1}, {{-1, -1, -1}, 1}}) == Kind::leaf);  // flat, but not without points
  CHECK(kind_of({{{1, 1, 1}, 1}, {{-1, 0, 0}, 0}, {{0, -1, 0}, 0}, {{0, 0, -1}, std::nextafter(-1.0, -2)}}) ==
        Kind::empty);
  CHECK(kind_of({}) == Kind::everything);
}

TEST_CASE("a convex polyhedron of points has one form a face, through its points exactly") {
  const std::vector<Point> cube{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},      {0, 0, 1},
                                {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {0.5, 0.5, 0.5}};
  const Solid solid = convex_from_points(cube);
  CHECK(solid.shape().forms.size() == 6);
  CHECK(solid.shape().vertices.size() == 8);
  CHECK(solid.shape().bounds == Box{{0, 0, 0}, {1, 1, 1}});
  CHECK(convex_from_points(std::vector<Point>(cube.begin(), cube.begin() + 4)).kind() == Kind::empty);
}

TEST_CASE("every point of a cloud is in its hull, and each corner on at least three faces") {
  testing::Random random(5);
  for (int round = 0; round < 20; ++round) {
    std::vector<Point> points;
    for (int i = 0; i < 40; ++i) points.push_back(random.point(10));
    const Solid solid = convex_from_points(points);
    for (const Point& p : points) CHECK(side(solid, p) <= 0);
    for (const Point& corner : solid.shape().vertices) {
      int faces = 0;
      for (const QuadricForm& f : solid.shape().forms) faces += f.at(corner).sign() == 0;
      CHECK(faces >= 3);
    }
  }
}
