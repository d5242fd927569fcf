// SPDX-License-Identifier: MIT
#include "csg/exact/hull.h"

#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>

#include "csg/base/length.h"
#include "csg/base/transform.h"
#include "csg/exact/dyadic.h"
#include "tests/support/catch.h"

using namespace csgcast;

namespace {

using Points = std::vector<Point>;

// A closed oriented mesh of one piece's Euler number that no point is outside of, every corner being one of the points.
void check_hull(const Points& points) {
  const std::vector<HullTriangle> hull = convex_hull(points);
  REQUIRE_FALSE(hull.empty());
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::set<std::uint32_t> corners;
  for (const HullTriangle& t : hull) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++edges[{t[i], t[(i + 1) % 3]}];
      corners.insert(t[i]);
    }
  }
  for (const auto& [edge, count] : edges) {
    REQUIRE(count == 1);
    REQUIRE(edges.count({edge.second, edge.first}) == 1);
  }
  CHECK(corners.size() + hull.size() == edges.size() / 2 + 2);
  std::size_t outside = 0;
  for (const HullTriangle& t : hull) {
    for (const Point& p : points) outside += orientation(points[t[0]], points[t[1]], points[t[2]], p) > 0;
  }
  CHECK(outside == 0);
}

struct Random {
  explicit Random(std::uint64_t seed) : engine(seed) {}
  double number() { return std::uniform_real_distribution<double>(-1, 1)(engine); }
  Point point() { return {number(), number(), number()}; }
  std::mt19937_64 engine;
};

// OpenSCAD's faceted sphere.
Points faceted_sphere(int facets, double radius) {
  Points points;
  const int rings = (facets + 1) / 2;
  for (int i = 0; i < rings; ++i) {
    const double polar = 180 * (i + 0.5) / rings;
    for (int j = 0; j < facets; ++j) {
      const double r = radius * sin_degrees(polar), turn = 360.0 * j / facets;
      points.push_back({r * cos_degrees(turn), r * sin_degrees(turn), radius * cos_degrees(polar)});
    }
  }
  return points;
}

Points lattice(int n, double step, double origin) {
  Points points;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) points.push_back({origin + i * step, origin + j * step, origin + k * step});
    }
  }
  return points;
}

int orientation_by_definition(Point a, Point b, Point c, Point d) {
  std::array<std::array<Dyadic, 3>, 3> m;
  for (std::size_t i = 0; i < 3; ++i)
    m[i] = {Dyadic(b[i]) - Dyadic(a[i]), Dyadic(c[i]) - Dyadic(a[i]), Dyadic(d[i]) - Dyadic(a[i])};
  Dyadic sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    sum += m[0][i] * m[1][j] * m[2][k] - m[0][i] * m[1][k] * m[2][j];
  }
  return sum.sign();
}

}  // namespace

TEST_CASE("orientation is positive on the side from which the triangle is counter-clockwise") {
  CHECK(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == 1);
  CHECK(orientation({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}) == -1);
  CHECK(orientation({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {5, 5, 0}) == 0);
}

TEST_CASE("orientation of nearly coplanar points at every scale is the exact sign") {
  Random random(1);
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.engine() % 1400) - 700);
    const Point a = random.point(), b = random.point(), c = random.point();
    const double s = random.number(), t = random.number();
    Point d = a + (s * (b - a) + t * (c - a));
    if (i % 3 == 0) d = a + 0.5 * (b - a);
    const auto scaled = [scale](Point p) { return Point{scale * p.x, scale * p.y, scale * p.z}; };
    const int sign = orientation(scaled(a), scaled(b), scaled(c), scaled(d));
    zeros += sign == 0;
    CHECK(sign == orientation_by_definition(scaled(a), scaled(b), scaled(c), scaled(d)));
    CHECK(sign == -orientation(scaled(b), scaled(a), scaled(c), scaled(d)));
  }
  CHECK(zeros > 0);
}

TEST_CASE("orientation survives overflow and underflow of the products") {
  const double huge = 1.7e308, tiny = 4.9e-324;
  CHECK(orientation({-huge, -huge, -huge}, {huge, -huge, -huge}, {-huge, huge, -huge}, {0, 0, huge}) == 1);
  CHECK(orientation({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}) == 1);
  CHECK(orientation({0, 0, 0}, {huge, 0, 0}, {0, tiny, 0}, {1, 1, -tiny}) == -1);
}

TEST_CASE("the hull of a cube's lattice is its six sides") {
  const Points points = lattice(6, 1, 0);
  check_hull(points);
  for (const HullTriangle& t : convex_hull(points)) {
    const Vector n = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
    CHECK((n.x != 0) + (n.y != 0) + (n.z != 0) == 1);
  }
}

TEST_CASE("hulls of degenerate and ill-conditioned points are closed and hold every point") {
  Random random(2);
  Points points;
  SECTION("random points in a cube") {
    for (int i = 0; i < 2000; ++i) points.push_back(random.point());
  }
  SECTION("random points on a sphere") {
    for (int i = 0; i < 800; ++i) points.push_back(Point{} + normalised(as_vector(random.point())));
  }
  SECTION("faceted spheres") { points = faceted_sphere(30, 10); }
  SECTION("faceted spheres with odd rings") { points = faceted_sphere(17, 0.1); }
  SECTION("faceted spheres, each point one unit in the last place off") {
    points = faceted_sphere(24, 1);
    for (Point& p : points) p.x = std::nextafter(p.x, 9 * random.number());
  }
  SECTION("every point twice") {
    points = faceted_sphere(12, 3);
    const Points again = points;
    points.insert(points.end(), again.begin(), again.end());
  }
  SECTION("a lattice of inexact steps, some points one unit in the last place off") {
    points = lattice(6, 0.1, 1);
    for (Point& p : points) {
      double& coordinate = p[random.engine() % 3];
      if (random.engine() % 3 == 0) coordinate = std::nextafter(coordinate, 9 * random.number());
    }
  }
  SECTION("a coplanar cloud and one point off it by the smallest number") {
    for (int i = 0; i < 300; ++i) points.push_back({random.number(), random.number(), 0});
    points.push_back({0, 0, 4.9e-324});
  }
  SECTION("a billionth of a unit wide, a million units off the origin") {
    for (int i = 0; i < 300; ++i) points.push_back(Point{1e6, 1e6, 1e6} + 1e-9 * as_vector(random.point()));
  }
  SECTION("subnormal coordinates") {
    for (int i = 0; i < 200; ++i) points.push_back(Point{} + 1e-310 * as_vector(random.point()));
  }
  SECTION("coordinates whose differences overflow") {
    for (int i = 0; i < 200; ++i) points.push_back(Point{} + 1.7e308 * as_vector(random.point()));
  }
  SECTION("axes of very different scale") {
    for (int i = 0; i < 200; ++i)
      points.push_back({1e300 * random.number(), random.number(), 1e-300 * random.number()});
  }
  check_hull(points);
}

TEST_CASE("points that span no volume have no hull") {
  CHECK(convex_hull(Points{}).empty());
  CHECK(convex_hull(Points(50, Point{1, 2, 3})).empty());
  Points collinear, coplanar;
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    collinear.push_back({1.0 * i, 2.0 * i, 3.0 * i});
    const double x = std::ldexp(std::round(1000 * random.number()), -10),
                 y = std::ldexp(std::round(1000 * random.number()), -10);
    coplanar.push_back({x, y, x + y});
  }
  CHECK(convex_hull(collinear).empty());
  CHECK(convex_hull(coplanar).empty());
}

TEST_CASE("the same points give the same triangles") {
  const Points points = faceted_sphere(20, 1);
  CHECK(convex_hull(points) == convex_hull(points));
}

TEST_CASE("the hull of five thousand points of a faceted sphere has them all as corners") {
  const Points points = faceted_sphere(100, 10);
  REQUIRE(points.size() == 5000);
  CHECK(convex_hull(points).size() == 2 * points.size() - 4);
}
