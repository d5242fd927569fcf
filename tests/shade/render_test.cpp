// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <vector>

#include "csg/base/error.h"
#include "csg/base/length.h"
#include "shade/film/camera.h"
#include "tests/shade/models.h"

using namespace csgcast;
using namespace csgcast::test;

namespace {

bool same_bits(const Film& a, const Film& b) {
  return a.values().size() == b.values().size() &&
         std::memcmp(a.values().data(), b.values().data(), a.values().size() * sizeof(float)) == 0;
}

Film draw(const Solid& solid, Mode mode, int size = 64) {
  return render(compile(solid), standard_view(), picture(size, size, mode));
}

}  // namespace

TEST_CASE("a picture is the same bit for bit on any number of threads, in every mode") {
  const Scene scene = compile(still_life());
  for (const Mode mode : {Mode::shaded, Mode::edges, Mode::xray, Mode::depth, Mode::normal, Mode::id}) {
    RenderOptions options = picture(90, 70, mode);
    options.samples = 4;
    options.threads = 1;
    RenderReport one;
    const Film reference = render(scene, standard_view(), options, &one);
    for (const int threads : {2, 5, 0}) {
      options.threads = threads;
      RenderReport report;
      REQUIRE(same_bits(render(scene, standard_view(), options, &report), reference));
      REQUIRE(report.rays.primary == one.rays.primary);
      REQUIRE(report.rays.shadow == one.rays.shadow);
      REQUIRE(report.casts.rays == one.casts.rays);
    }
  }
}

TEST_CASE("a picture does not depend on how the solid is written") {
  const Solid ball = sphere(1.35);
  const Solid cube = box({2, 2, 2}, Centering::centered);
  const Solid bore = at(cylinder(4, 0.6, 0.6), {0, 0, -2});
  const Film reference = draw((cube & ball) - bore, Mode::shaded);
  REQUIRE(same_bits(draw(cube & ball & complement(bore), Mode::shaded), reference));
  REQUIRE(same_bits(draw((cube - bore) & (ball - bore), Mode::shaded), reference));
  REQUIRE(same_bits(draw(complement(complement(cube) + complement(ball) + bore), Mode::shaded), reference));
  REQUIRE_FALSE(same_bits(draw(cube & ball, Mode::shaded), reference));
}

TEST_CASE("a pixel is the mean of its samples in linear light") {
  // A glowing half-space whose edge runs through the picture.
  Material glow = mirror(0);
  glow.emission = {1, 1, 1};
  const Scene scene = compile(painted(halfspace({1, 0, 0}, 0.25) & halfspace({0, 0, 1}, 0), glow));
  View view = standard_view();
  view.camera = {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 30, 1.0};
  view.background = {};
  RenderOptions options = picture(1, 1);
  REQUIRE(render(scene, view, options).value(0, 0) == 1);
  options.samples = 16;  // columns at -3/8, -1/8, 1/8, 3/8: three of four are lit
  RenderReport report;
  REQUIRE(render(scene, view, options, &report).value(0, 0) == 0.75F);
  REQUIRE(report.rays.primary == 16);
  options.samples = 10;  // rounded up to 16
  REQUIRE(render(scene, view, options).value(0, 0) == 0.75F);
}

TEST_CASE("the report counts a ray for each that was cast") {
  RenderReport report;
  RenderOptions options = picture(40, 30);
  options.engine = Engine::scalar;
  render(compile(still_life()), standard_view(), options, &report);
  const RayCounts& rays = report.rays;
  REQUIRE(rays.primary == 40 * 30);
  REQUIRE(rays.shadow > 0);
  REQUIRE(rays.reflection > 0);
  REQUIRE(rays.transmission > 0);
  REQUIRE(report.casts.rays == rays.primary + rays.shadow + rays.reflection + rays.transmission);
  REQUIRE(report.seconds > 0);
}

TEST_CASE("progress tells of each tile on one thread, ascends to 1, and what it throws ends the render") {
  const Scene scene = compile(angel());
  RenderOptions options = picture(100, 100);
  std::vector<double> told;
  options.threads = 1;
  options.progress = [&](const Progress& progress) {
    told.push_back(progress.share);
    return true;
  };
  render(scene, standard_view(), options);
  REQUIRE(told.size() == 16);
  REQUIRE(std::is_sorted(told.begin(), told.end()));
  REQUIRE(told.back() == 1);
  options.progress = [](const Progress&) -> bool { throw std::runtime_error("enough"); };
  REQUIRE_THROWS_WITH(render(scene, standard_view(), options), "enough");
}

TEST_CASE("depth is the distance from the eye, of parallel views from the plane of the eye") {
  const Scene scene = compile(sphere(1));
  View view = standard_view();
  view.camera = {{0, -5, 0}, {0, 0, 0}, {0, 0, 1}, 30, std::nullopt};
  const Film film = render(scene, view, picture(31, 31, Mode::depth));
  REQUIRE(film.value(15, 15) == 4);
  REQUIRE(film.value(0, 0) == std::numeric_limits<float>::infinity());
  REQUIRE(film.value(18, 15) > 4);
  view.camera.height = 4;
  REQUIRE(render(scene, view, picture(31, 31, Mode::depth)).value(15, 15) == 4);
}

TEST_CASE("an x-ray shows how long each ray is inside, cavities not counted, and infinite lengths as such") {
  View view = standard_view();
  view.camera = {{0, -5, 0}, {0, 0, 0}, {0, 0, 1}, 30, std::nullopt};
  const Scene hollow = compile(sphere(1) - sphere(0.25));
  REQUIRE(render(hollow, view, picture(31, 31, Mode::xray)).value(15, 15) == 1.5F);
  REQUIRE(render(hollow, view, picture(31, 31, Mode::xray)).value(0, 0) == 0);
  REQUIRE(std::isinf(render(compile(halfspace({0, -1, 0}, 0)), view, picture(3, 3, Mode::xray)).value(1, 1)));
}

TEST_CASE("normals are of unit length and face the viewer") {
  const View view = standard_view();
  const Camera camera(view.camera, 64, 64);
  const Film film = draw(angel(), Mode::normal);
  int seen = 0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const Rgb c = film.rgb(x, y);
      if (c == Rgb{}) continue;
      const Vector n{2 * c.r - 1, 2 * c.g - 1, 2 * c.b - 1};
      REQUIRE(length(n) == Approx(1).margin(1e-6));
      REQUIRE(dot(n, camera.ray(x + 0.5, y + 0.5).direction()) < 1e-6);
      ++seen;
    }
  }
  REQUIRE(seen > 500);
}

TEST_CASE("sizes and samples that make no picture are refused") {
  const Scene scene = compile(sphere(1));
  const auto refused = [&](RenderOptions options) {
    REQUIRE_THROWS_AS(render(scene, standard_view(), options), Error);
  };
  refused(picture(0, 10));
  refused(picture(10, -1));
  refused(picture(65537, 1));
  refused(picture(65536, 65536));
  RenderOptions options = picture(10, 10);
  options.samples = 0;
  refused(options);
  options.samples = 1025;
  refused(options);
  REQUIRE_THROWS_AS(trace_pixel(scene, standard_view(), picture(10, 10), 10, 0), Error);
  REQUIRE_THROWS_AS(trace_pixel(scene, standard_view(), picture(10, 10), 0, -1), Error);
  REQUIRE_THROWS_AS(trace_pixel(scene, standard_view(), picture(10, 10, Mode::depth), 0, 0), Error);
}

TEST_CASE("the tree of a pixel begins with the pixel's colour in the picture") {
  const Scene scene = compile(angel());
  const Film film = render(scene, standard_view(), picture(64, 64));
  const std::string text = trace_pixel(scene, standard_view(), picture(64, 64), 40, 30);
  double r = 0;
  double g = 0;
  double b = 0;
  REQUIRE(std::sscanf(text.c_str(), "pixel 40,30: linear [%lf %lf %lf]", &r, &g, &b) == 3);
  require_close(film.rgb(40, 30), {r, g, b}, 1e-5);
}

TEST_CASE("a scene text without camera, light and background still makes a picture of its solid in the light") {
  SceneDescription description;
  description.solid = at(angel(), {100, -50, 20});
  const Scene scene = compile(description.solid);
  const View view = make_view(description, scene, 1);
  const Film ids = render(scene, view, picture(40, 40, Mode::id));
  const Film light = render(scene, view, picture(40, 40));
  int seen = 0;
  int lit = 0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      const bool border = x == 0 || y == 0 || x == 39 || y == 39;
      if (border) REQUIRE(ids.value(x, y) == -1);
      if (ids.value(x, y) < 0) continue;
      ++seen;
      lit += light.value(x, y, 0) > 0.3 ? 1 : 0;
    }
  }
  REQUIRE(seen > 400);
  REQUIRE(lit > seen / 2);
}
