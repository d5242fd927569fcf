// SPDX-License-Identifier: MIT
#include <cmath>

#include "csg/base/length.h"
#include "shade/film/camera.h"
#include "tests/shade/models.h"

using namespace csgcast;
using namespace csgcast::test;

namespace {

Solid floor_at_zero() { return painted(halfspace({0, 0, 1}, 0), matte()); }

// Compares every pixel that meets a ball (about `center`, seen from outside or from within) with the cosine that a
// light must give.
void require_no_specks(Stage& stage, const CameraDescription& description, Point center, double radius, Point light,
                       double margin) {
  constexpr int size = 120;
  const Camera camera(description, size, size);
  const bool within = length(description.eye - center) < radius;
  int met = 0;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const Ray ray = camera.ray(x + 0.5, y + 0.5);
      const Vector from_center = ray.origin() - center;
      const double b = dot(ray.direction(), from_center);
      const double discriminant = b * b - dot(from_center, from_center) + radius * radius;
      if (discriminant < 1e-6 * radius * radius)
        continue;  // at the silhouette the two computations may disagree on the hit
      const Point p = ray.at(within ? -b + std::sqrt(discriminant) : -b - std::sqrt(discriminant));
      const Vector n = (within ? -1 / radius : 1 / radius) * (p - center);
      const double cosine = dot(n, normalised(light - p));
      const Rgb color = stage.trace(ray.origin(), ray.direction());
      CAPTURE(x, y, cosine, color.r);
      REQUIRE(std::fabs(color.r - std::fmax(cosine, 0)) < margin);
      ++met;
    }
  }
  REQUIRE(met > size * size / 4);
}

CameraDescription camera_at(Point eye, Point look_at, double fov) {
  CameraDescription camera;
  camera.eye = eye;
  camera.look_at = look_at;
  camera.fov = fov;
  return camera;
}

}  // namespace

TEST_CASE("a ball throws a round shadow on the floor") {
  // Light at height 10, a ball of radius 1 at height 5: by similar triangles the shadow's radius is 10 tan(asin(1/5)).
  Stage stage(floor_at_zero() + painted(at(sphere(1), {0, 0, 5}), matte()), {point_light({0, 0, 10})});
  const double radius = 10 * std::tan(std::asin(0.2));
  for (const double angle : {0.0, 1.0, 2.0, 3.0}) {
    const auto floor = [&](double r) {
      return stage.trace({r * std::cos(angle), r * std::sin(angle), 0.5}, {0, 0, -1}).r;
    };
    REQUIRE(floor(radius * 0.999) == 0);
    REQUIRE(floor(radius * 1.001) == Approx(10 / std::hypot(10, radius * 1.001)).epsilon(1e-12));
  }
}

TEST_CASE("what is beyond a point light throws no shadow, what is before a light at infinity does") {
  const Solid scene = floor_at_zero() + painted(at(sphere(1), {0, 0, 5}), matte());
  REQUIRE(Stage(scene, {point_light({0, 0, 3})}).trace({0, 0, 1}, {0, 0, -1}).r == 1);
  REQUIRE(Stage(scene, {sun({0, 0, -1})}).trace({0, 0, 1}, {0, 0, -1}).r == 0);
  REQUIRE(Stage(scene, {sun({0, 0, -1})}).trace({3, 0, 1}, {0, 0, -1}).r == 1);
}

TEST_CASE("two lights add up, and each has its own shadow") {
  Stage stage(floor_at_zero() + painted(at(sphere(1), {0, 0, 5}), matte()), {sun({0, 0, -1}), sun({-1, 0, -1})});
  REQUIRE(stage.trace({0, 0, 1}, {0, 0, -1}).r == Approx(std::sqrt(0.5)).epsilon(1e-12));  // in the first's shadow
  REQUIRE(stage.trace({-5, 0, 1}, {0, 0, -1}).r == Approx(1).epsilon(1e-12));              // in the second's
  REQUIRE(stage.trace({20, 0, 1}, {0, 0, -1}).r == Approx(1 + std::sqrt(0.5)).epsilon(1e-12));
}

TEST_CASE("no ball shadows itself: every pixel shows the cosine, grazing ones too") {
  for (const Point center : {Point{0, 0, 0}, Point{1e6, -3e5, 7}}) {
    // Beside the camera, and so far to the side that most of what is seen is lit at a grazing angle.
    for (const Vector offset : {Vector{0.1, -5, 0.2}, Vector{30, 1, 3}}) {
      const Point light = center + offset;
      Stage stage(painted(at(sphere(1), as_vector(center)), matte()), {point_light(light)});
      const double rounding = 1e-15 * length(center);  // of the hit point, which the normal repeats
      require_no_specks(stage, camera_at(center + Vector{0, -5, 0}, center, 24), center, 1, light,
                        1e-11 + 64 * rounding);
    }
  }
}

TEST_CASE("no hollow shadows itself: a cavity lit from within shows the cosine in every pixel") {
  const Solid hollow = painted(at(box({6, 6, 6}, Centering::centered) - sphere(2), {0, 0, 1}), matte());
  const Point light{0.5, 0.3, 1.4};
  Stage stage(hollow, {point_light(light)});
  require_no_specks(stage, camera_at({0, -1, 1}, {0, 0, 1}, 70), {0, 0, 1}, 2, light, 1e-11);
}

TEST_CASE("in the light of a lamp at the eye whatever is seen is lit: no solid, at any scale and place, has specks") {
  const Solid cone = quadric({1, 1, -0.5, 0, 0, 0}, {0, 0, 0}, 0) & box({3, 3, 3}, Centering::centered);
  const Solid saddle = quadric({1, -1, 0, 0, 0, 0}, {0, 0, 1}, 0) & sphere(1.6);
  const Solid waist = hyperboloid(3, 1.4, 0.5);
  const Solid lens = ellipsoid({1.5, 0.2, 1}) & at(sphere(1.2), {0.3, 0, 0});
  const Transform turned = rotation(31, {1, 2, 3});
  int seen = 0;
  for (const Solid& solid : {angel(), flush(2), cone, saddle, waist, lens, angel() - waist}) {
    for (const double scale : {1.0, 1e-6, 1e7}) {
      for (const Vector& offset : {Vector{0, 0, 0}, Vector{1e4, -3e3, 2e2}}) {
        const Solid moved = at(transformed(transformed(solid, turned), scaling({scale, scale, scale})), scale * offset);
        const CameraDescription description = [&] {
          CameraDescription camera = standard_view().camera;
          const Vector away = camera.eye - camera.look_at;
          camera.look_at = Point{} + scale * offset;
          camera.eye = camera.look_at + scale * away;
          return camera;
        }();
        Stage stage(painted(moved, matte()), {point_light(description.eye)});
        stage.view.background = {-1, -1, -1};
        const Camera camera(description, 48, 48);
        for (int i = 0; i < 48 * 48; ++i) {
          const Ray ray = camera.ray(i % 48 + 0.5, i / 48 + 0.5);
          const Rgb color = stage.trace(ray.origin(), ray.direction());
          if (color.r < 0) continue;
          stage.caster.begin(ray);
          const Attribution face = stage.caster.attribute(*stage.caster.first_hit());
          CAPTURE(scale, offset.x, i);
          REQUIRE(color.r == Approx(std::fabs(dot(face.normal, ray.direction()))).margin(1e-8));
          ++seen;
        }
      }
    }
  }
  REQUIRE(seen > 10000);
}

TEST_CASE("no ray is sent to a light that is behind the surface or adds nothing") {
  Stage away(floor_at_zero(), {sun({0, 0, 1})});
  away.trace({0, 0, 1}, {0, 0, -1});
  REQUIRE(away.report.rays.shadow == 0);
  REQUIRE(away.report.skipped.shadow_facing_away == 1);
  LightDescription dark = sun({0, 0, -1});
  dark.intensity = 0;
  Stage without(floor_at_zero(), {dark});
  without.trace({0, 0, 1}, {0, 0, -1});
  REQUIRE(without.report.rays.shadow == 0);
  REQUIRE(without.report.skipped.shadow_without_effect == 1);
}

TEST_CASE("glass dims a light by its two faces and its medium, and does not block it") {
  Material glass = clear_glass(1.5, {0.4, 0.2, 0});
  glass.transmission = 0.8;
  const Solid pane = painted(block({-5, -5, 2}, {5, 5, 2.5}), glass);
  Stage stage(floor_at_zero() + pane, {sun({0, 0, -1})});
  const Rgb share = 0.8 * 0.8 * transmittance({0.4, 0.2, 0}, 0.5);
  require_close(stage.trace({0, 0, 1}, {0, 0, -1}), share);
  require_close(stage.trace({6, 0, 1}, {0, 0, -1}), {1, 1, 1});
  // A light within the pane is dimmed by one face and half of the medium.
  Stage within(floor_at_zero() + pane, {point_light({0, 0, 2.25})});
  require_close(within.trace({0, 0, 1}, {0, 0, -1}), 0.8 * transmittance({0.4, 0.2, 0}, 0.25));
}

TEST_CASE("an opaque solid behind glass blocks the light") {
  const Solid pane = painted(block({-5, -5, 2}, {5, 5, 2.5}), clear_glass(1.5));
  Stage stage(floor_at_zero() + pane + painted(block({-1, -1, 3}, {1, 1, 4}), matte()), {sun({0, 0, -1})});
  REQUIRE(stage.trace({0, 0, 1}, {0, 0, -1}).r == 0);
  REQUIRE(stage.trace({2, 0, 1}, {0, 0, -1}).r == 1);
}

TEST_CASE("an opaque solid blocks the light also where it was cut with the colour of glass") {
  const Solid dented =
      painted(block({-2, -2, 3}, {2, 2, 5}), matte()) - painted(at(sphere(1), {0, 0, 3}), clear_glass(1.5));
  Stage stage(floor_at_zero() + dented + painted(at(sphere(1), {9, 9, 9}), clear_glass(1.5)), {sun({0, 0, -1})});
  REQUIRE(stage.trace({0, 0, 1}, {0, 0, -1}).r == 0);
  REQUIRE(stage.trace({3, 0, 1}, {0, 0, -1}).r == 1);
}
