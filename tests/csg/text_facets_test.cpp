// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include "csg/exact/hull.h"
#include "csg/solid/leaf_shape.h"
#include "csg/text/statement/detail/facets.h"
#include "tests/csg/text_support.h"
#include "tests/support/catch.h"

namespace csgcast::text {
namespace {

double hull_volume(const std::vector<Point>& points) {
  double six_volumes = 0;
  for (const HullTriangle& t : convex_hull(points)) {
    const Vector a = points[t[0]] - Point{}, b = points[t[1]] - Point{}, c = points[t[2]] - Point{};
    six_volumes += dot(a, cross(b, c));
  }
  return six_volumes / 6;
}

double sphere_volume(double radius, const Fineness& fineness) {
  return hull_volume(sphere_vertices(radius, static_cast<int>(side_count(radius, fineness))));
}

/// Faces of the polyhedron that a solid statement makes; 0 if it keeps its curve.
std::size_t vertex_count(std::string_view text, Facets facets) {
  const Solid solid = build_text(text, facets).solid;
  REQUIRE(solid.kind() == Solid::Kind::leaf);
  return solid.shape().is_convex_polyhedron ? solid.shape().vertices.size() : 0;
}

}  // namespace

TEST_CASE("circles get as many sides as in OpenSCAD") {
  CHECK(side_count(10, {}) == 30);          // 360 / 12
  CHECK(side_count(1, {}) == 5);            // the least by $fa and $fs
  CHECK(side_count(4, {}) == 13);           // ceil(8 pi / 2)
  CHECK(side_count(10, {.fn = 5.7}) == 5);  // truncated
  CHECK(side_count(10, {.fn = 1}) == 3);
  CHECK(side_count(10, {.fn = -3}) == 30);  // as if not given
  CHECK(side_count(10, {.fn = 100}) == 100);
  CHECK(side_count(0x1p-21, {.fn = 100}) == 3);     // below OpenSCAD's grid
  CHECK(side_count(1, {.fa = 0, .fs = 0}) == 629);  // clamped to 0.01: ceil(2 pi / 0.01)
}

TEST_CASE("a sphere's polyhedron has the volume that OpenSCAD gives it") {
  CHECK(sphere_volume(10, {}) == Approx(4112.86218).epsilon(1e-8));
  CHECK(sphere_volume(1, {.fn = 4}) == Approx(1.41421356).epsilon(1e-8));
  CHECK(sphere_volume(1, {.fn = 5}) == Approx(2.40228072).epsilon(1e-8));
}

TEST_CASE("a sphere's vertices are rings between the poles, each from +x") {
  const std::vector<Point> vertices = sphere_vertices(10, 30);
  REQUIRE(vertices.size() == 15 * 30);
  CHECK(vertices.front().z == Approx(9.94522).epsilon(1e-6));
  CHECK(vertices.front().y == 0);
  CHECK(vertices.back().z == -vertices.front().z);
  const std::vector<Point> octahedron_like = sphere_vertices(2, 4);
  REQUIRE(octahedron_like.size() == 8);
  CHECK(octahedron_like[1].x == 0);  // exact at a right angle
  CHECK(octahedron_like[1].y == 2 * std::sqrt(0.5));
}

TEST_CASE("a cylinder's vertices are two polygons of one phase, or one and an apex") {
  const std::vector<Point> hexagon = cylinder_vertices(0, 5, 2, 1, 6);
  REQUIRE(hexagon.size() == 12);
  CHECK(hexagon[0] == Point{2, 0, 0});
  CHECK(hexagon[1].x == 1);
  CHECK(hexagon[1].y == Approx(std::sqrt(3.0)).epsilon(1e-15));
  CHECK(hexagon[3] == Point{-2, 0, 0});
  CHECK(hexagon[6] == Point{1, 0, 5});
  const std::vector<Point> pyramid = cylinder_vertices(-1, 1, 3, 0, 4);
  REQUIRE(pyramid.size() == 5);
  CHECK(pyramid[1] == Point{0, 3, -1});
  CHECK(pyramid[4] == Point{0, 0, 1});
  CHECK(hull_volume(pyramid) == Approx(12).epsilon(1e-14));
}

TEST_CASE("by default only an explicit $fn of at most 16 makes a polygon") {
  CHECK(vertex_count("cylinder(h = 1, r = 1, $fn = 6);", Facets::automatic) == 12);
  CHECK(vertex_count("cylinder(h = 1, r = 1, $fn = 16);", Facets::automatic) == 32);
  CHECK(vertex_count("cylinder(h = 1, r = 1, $fn = 17);", Facets::automatic) == 0);
  CHECK(vertex_count("cylinder(h = 1, r = 1, $fn = 0, $fa = 60, $fs = 1);", Facets::automatic) == 0);
  CHECK(vertex_count("cylinder(h = 1, r = 1, $fn = inf);", Facets::automatic) == 0);
  CHECK(vertex_count("sphere(1, $fn = 4);", Facets::automatic) == 8);
}

TEST_CASE("facets may be asked for always or never") {
  CHECK(vertex_count("cylinder(h = 1, r = 10);", Facets::always) == 60);
  CHECK(vertex_count("cylinder(h = 1, r1 = 10, r2 = 0);", Facets::always) == 31);
  CHECK(vertex_count("sphere(r = 1);", Facets::always) == 15);
  CHECK(vertex_count("ellipsoid([1, 2, 3]);", Facets::always) == 0);
  CHECK(vertex_count("cylinder(h = 1, r = 10, $fn = 6);", Facets::never) == 0);
}

TEST_CASE("more facets than memory should hold are refused") {
  const auto error = error_of("sphere(1, $fn = 1e300);", Facets::always);
  REQUIRE(error);
  CHECK(error->code() == ErrorCode::limit);
  CHECK_FALSE(error_of("sphere(1, $fn = 1e300);", Facets::automatic));
}

}  // namespace csgcast::text
