// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <numbers>

#include "csg/base/error.h"
#include "csg/base/length.h"
#include "shade/film/camera.h"
#include "shade/film/view.h"
#include "tests/support/catch.h"

using namespace csgcast;

namespace {

CameraDescription looking_north() {
  CameraDescription camera;
  camera.eye = {1, 2, 3};
  camera.look_at = {1, 7, 3};
  camera.fov = 90;
  return camera;
}

void require_close(Vector is, Vector should_be) {
  CAPTURE(is.x, is.y, is.z, should_be.x, should_be.y, should_be.z);
  REQUIRE(length(is - should_be) < 1e-14 * (1 + length(should_be)));
}

}  // namespace

TEST_CASE("the middle of a perspective picture looks at look_at, its right to the viewer's right, its top up") {
  const Camera camera(looking_north(), 200, 100);
  REQUIRE(camera.ray(100, 50).origin() == Point{1, 2, 3});
  require_close(camera.ray(100, 50).direction(), {0, 1, 0});
  require_close(camera.ray(100, 0).direction(), normalised(Vector{0, 1, 1}));  // half of 90 degrees up
  require_close(camera.ray(100, 100).direction(), normalised(Vector{0, 1, -1}));
  require_close(camera.ray(200, 50).direction(), normalised(Vector{2, 1, 0}));  // twice as wide as high
  require_close(camera.ray(0, 0).direction(), normalised(Vector{-2, 1, 1}));
}

TEST_CASE("a parallel picture shows its height and its rays have one direction") {
  CameraDescription description = looking_north();
  description.height = 4;
  const Camera camera(description, 100, 100);
  REQUIRE(camera.ray(100, 0).origin() == Point{3, 2, 5});
  REQUIRE(camera.ray(0, 100).origin() == Point{-1, 2, 1});
  REQUIRE(camera.ray(3, 8).direction() == Vector{0, 1, 0});
  REQUIRE(camera.footprint(7) == Approx(0.04));
}

TEST_CASE("a camera whose up is along its view takes another up") {
  CameraDescription down = looking_north();
  down.look_at = {1, 2, 0};
  require_close(Camera(down, 100, 100).ray(50, 0).direction(), normalised(Vector{0, 1, -1}));
  down.up = {0, 0, 0};
  require_close(Camera(down, 100, 100).ray(50, 0).direction(), normalised(Vector{0, 1, -1}));
  CameraDescription north = looking_north();
  north.up = {0, -3, 0};
  require_close(Camera(north, 100, 100).ray(50, 0).direction(), normalised(Vector{0, 1, 1}));
}

TEST_CASE("cameras that see nothing are refused") {
  const auto refused = [](auto&& change) {
    CameraDescription camera = looking_north();
    change(camera);
    REQUIRE_THROWS_AS(Camera(camera, 10, 10), Error);
  };
  refused([](CameraDescription& c) { c.look_at = c.eye; });
  refused([](CameraDescription& c) { c.fov = 0; });
  refused([](CameraDescription& c) { c.fov = 180; });
  refused([](CameraDescription& c) { c.fov = std::nan(""); });
  refused([](CameraDescription& c) { c.height = 0; });
  refused([](CameraDescription& c) { c.height = -1; });
  refused([](CameraDescription& c) { c.eye.x = std::numeric_limits<double>::infinity(); });
  refused([](CameraDescription& c) { c.eye.x = -1e308, c.look_at.x = 1e308; });
}

TEST_CASE("OpenSCAD's six numbers are eye and centre") {
  const CameraDescription camera = camera_from_numbers({1, 2, 3, 4, 5, 6});
  REQUIRE(camera.eye == Point{1, 2, 3});
  REQUIRE(camera.look_at == Point{4, 5, 6});
  REQUIRE(camera.fov == 22.5);
}

TEST_CASE("OpenSCAD's seven numbers turn a camera that looks down, and move it") {
  const CameraDescription top = camera_from_numbers({1, 2, 3, 0, 0, 0, 10});
  REQUIRE(top.eye == Point{1, 2, 13});
  REQUIRE(top.look_at == Point{1, 2, 3});
  REQUIRE(top.up == Vector{0, 1, 0});
  const CameraDescription front = camera_from_numbers({0, 0, 0, 90, 0, 0, 10});
  REQUIRE(front.eye == Point{0, -10, 0});
  REQUIRE(front.up == Vector{0, 0, 1});
  const CameraDescription right = camera_from_numbers({0, 0, 0, 90, 0, 90, 10});
  REQUIRE(right.eye == Point{10, 0, 0});
  REQUIRE(right.up == Vector{0, 0, 1});
}

TEST_CASE("a camera of another count of numbers, or of no number, is refused") {
  REQUIRE_THROWS_AS(camera_from_numbers({1, 2, 3, 4, 5}), Error);
  REQUIRE_THROWS_AS(camera_from_numbers({}), Error);
  REQUIRE_THROWS_AS(camera_from_numbers({1, 2, 3, 4, 5, std::nan("")}), Error);
}

TEST_CASE("the default camera frames a box: all corners are in the picture, one of them near its border") {
  for (const double aspect : {0.5, 1.0, 2.5}) {
    const Box wanted{{1e3, -2, 5}, {1e3 + 4, 3, 6}};
    const CameraDescription description = framing_camera(wanted, aspect);
    const double tan_y = std::tan(description.fov / 360 * std::numbers::pi);
    const Vector forward = normalised(description.look_at - description.eye);
    const Vector right = normalised(cross(forward, description.up));
    const Vector up = cross(right, forward);
    double farthest = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const Point p{(corner & 1) != 0 ? wanted.lower.x : wanted.upper.x,
                    (corner & 2) != 0 ? wanted.lower.y : wanted.upper.y,
                    (corner & 4) != 0 ? wanted.lower.z : wanted.upper.z};
      const Vector v = p - description.eye;
      const double depth = dot(v, forward);
      REQUIRE(depth > 0);
      farthest = std::fmax(farthest, std::fabs(dot(v, right)) / (depth * tan_y * aspect));
      farthest = std::fmax(farthest, std::fabs(dot(v, up)) / (depth * tan_y));
    }
    REQUIRE(farthest < 1);
    REQUIRE(farthest > 0.9);
  }
}

TEST_CASE("a solid without a finite box, or without size, still gets a camera") {
  for (const Box& box : {Box{}, Box::everything(), Box{{1e6, 0, 0}, {1e6, 0, 0}}, Box{{0, 0, 0}, {0, 0, 0}}}) {
    const CameraDescription camera = framing_camera(box, 1);
    REQUIRE_NOTHROW(Camera(camera, 10, 10));
    REQUIRE(headlight(camera).position.has_value());
    REQUIRE(is_finite(*headlight(camera).position));
  }
}
