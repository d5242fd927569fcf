// SPDX-License-Identifier: MIT
#include "verify/surface_geometry.h"

#include <array>
#include <cmath>

#include "csg/base/length.h"
#include "csg/exact/dyadic.h"
#include "csg/exact/quadric_form.h"
#include "raycast/surface/predicates.h"
#include "tests/support/catch.h"
#include "tests/verify/models.h"

using namespace csgcast;

namespace {

std::vector<SurfaceId> all_surfaces(const Scene& scene) {
  std::vector<SurfaceId> ids;
  for (std::uint32_t i = 0; i < scene.surfaces().size(); ++i) ids.emplace_back(i);
  return ids;
}

SurfaceId the_quadric(const Scene& scene) {
  for (const SurfaceId id : all_surfaces(scene)) {
    if (!scene.surface(id).is_plane) return id;
  }
  return {};
}

// f divided by the length of its gradient: how far from the surface a point is, nearly.
double distance(const Surface& surface, Point p) {
  const QuadricForm form = surface.exact.unpacked();
  const auto& c = form.coefficient;
  const double slope =
      length(Vector{(Dyadic(2.0) * c[0] * Dyadic(p.x) + c[3] * Dyadic(p.y) + c[4] * Dyadic(p.z) + c[6]).nearest(),
                    (Dyadic(2.0) * c[1] * Dyadic(p.y) + c[3] * Dyadic(p.x) + c[5] * Dyadic(p.z) + c[7]).nearest(),
                    (Dyadic(2.0) * c[2] * Dyadic(p.z) + c[4] * Dyadic(p.x) + c[5] * Dyadic(p.y) + c[8]).nearest()});
  return std::fabs(form.at(p).nearest()) / slope;
}

}  // namespace

TEST_CASE("three planes of a box at representable places meet in a corner, exactly") {
  const Scene scene = compile(transformed(box({0.75, 1.5, 3}), translation({1e9, -0.25, 1024})));
  const std::vector<SurfaceId> ids = all_surfaces(scene);
  int corners = 0;
  for (const SurfaceId a : ids) {
    for (const SurfaceId b : ids) {
      for (const SurfaceId c : ids) {
        const auto p = verify::meeting_point(scene, std::array{a, b, c}, {0.3, 0.4, 0.5});
        if (!p) continue;
        for (const SurfaceId id : {a, b, c}) CHECK(sign_at(scene.surface(id), *p) == 0);
        ++corners;
      }
    }
  }
  CHECK(corners == 8 * 6);  // each in every order
}

TEST_CASE("parallel planes and a sphere beside a plane have no meeting point") {
  const Scene plates = compile(box({1, 1, 1}) & halfspace({2, 0, 0}, 1));
  CHECK_FALSE(verify::meeting_point(plates, std::array{SurfaceId(0), SurfaceId(0)}, {}));
  const Scene apart = compile(sphere(1) + halfspace({0, 0, 1}, -2));
  CHECK_FALSE(verify::meeting_point(apart, all_surfaces(apart), {0.1, 0.2, 0.3}));
}

TEST_CASE("meeting points of curved surfaces are within a few ulps of both") {
  for (const double size : {1.0, 0x1p-300, 0x1p300}) {
    const Scene scene =
        compile(sphere(size) + transformed(cylinder(size, 0.7 * size, 0.7 * size), rotation(Vector{20, 30, 0})));
    const std::vector<SurfaceId> ids = all_surfaces(scene);
    int found = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const auto p = verify::meeting_point(scene, std::array{ids[i], ids[j]}, {0.3 * size, 0.5 * size, 0.2 * size});
        if (!p) continue;
        ++found;
        for (const SurfaceId id : {ids[i], ids[j]}) CHECK(distance(scene.surface(id), *p) < 0x1p-50 * size);
      }
    }
    CHECK(found >= 3);
  }
}

TEST_CASE("the apex of a cone and the center of a ball are found exactly, and cylinders and paraboloids have none") {
  const Vector offset{3.25, -1e6, 0.125};
  const auto center = [&](const Solid& solid) {
    const Scene scene = compile(transformed(solid, translation(offset)));
    return verify::center_of(scene, the_quadric(scene));
  };
  CHECK(center(cylinder(2, 1, 0)) == Point{} + offset + Vector{0, 0, 2});
  CHECK(center(sphere(0.3)) == Point{} + offset);
  CHECK(center(ellipsoid({1, 2, 0.1})) == Point{} + offset);
  CHECK_FALSE(center(cylinder(2, 1, 1)));
  CHECK_FALSE(center(paraboloid(1, 1)));
}

TEST_CASE("the straight lines through a point of a quadric: two, one, or none") {
  const auto lines = [](const Solid& solid, Point p) {
    const Scene scene = compile(solid);
    return verify::straight_lines(scene, the_quadric(scene), p);
  };
  CHECK(lines(sphere(1), {0, 0.6, 0.8}).empty());
  CHECK(lines(paraboloid(1, 1), {1, 0, 1}).empty());

  const std::vector<Vector> on_cylinder = lines(cylinder(2, 1, 1), {0.6, 0.8, 1});
  REQUIRE(on_cylinder.size() == 1);
  CHECK(cross(on_cylinder[0], {0, 0, 1}) == Vector{});

  const std::vector<Vector> on_cone = lines(cylinder(2, 2, 0), {0.6, 0.8, 1});  // to the apex (0, 0, 2)
  REQUIRE(on_cone.size() == 1);
  CHECK(length(cross(on_cone[0], {-0.6, -0.8, 1})) < 1e-9);

  const std::vector<Vector> on_hyperboloid = lines(hyperboloid(2, std::sqrt(2.0), 1), {1, 0, 0});
  REQUIRE(on_hyperboloid.size() == 2);
  for (const Vector d : on_hyperboloid) {
    CHECK(d.x == 0);
    CHECK(std::fabs(std::fabs(d.y) - std::fabs(d.z)) < 1e-9);
  }
  CHECK(lines(cylinder(2, 2, 0), {0, 0, 2}).empty());  // the apex
}
