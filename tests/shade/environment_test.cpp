// SPDX-License-Identifier: MIT
#include "shade/light/environment.h"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <tuple>

#include "csg/base/error.h"
#include "csg/solid/primitives.h"
#include "shade/film/camera.h"
#include "shade/picture/image_file.h"
#include "shade/trace/channels.h"
#include "shade/trace/render.h"
#include "tests/support/catch.h"

using namespace csgcast;

namespace {

/// Red grows from left to right, green from top to bottom.
std::shared_ptr<const Environment> ramp(int width, int height) {
  std::vector<float> rgb;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      rgb.push_back((static_cast<float>(x) + 0.5F) / static_cast<float>(width));
      rgb.push_back((static_cast<float>(y) + 0.5F) / static_cast<float>(height));
      rgb.push_back(0);
    }
  }
  return std::make_shared<const Environment>(width, height, std::move(rgb));
}

View view_of(std::shared_ptr<const Environment> environment) {
  View view;
  view.camera.eye = {0, -5, 0};
  view.camera.look_at = {0, 0, 0};
  view.lights.push_back({.position = Point{0, -5, 5}, .direction = {}, .falloff = {}});
  view.environment = std::move(environment);
  return view;
}

}  // namespace

TEST_CASE("the middle of an environment is +y, a quarter to the right is +x, its upper edge is +z") {
  const auto sky = ramp(64, 32);
  const Rgb north = sky->color({0, 1, 0});
  CHECK(north.r == Approx(0.5));
  CHECK(north.g == Approx(0.5));
  CHECK(sky->color({1, 0, 0}).r == Approx(0.75));
  CHECK(sky->color({-1, 0, 0}).r == Approx(0.25));
  CHECK(sky->color({0, 0, 3}).g == Approx(0.5 / 32));
  CHECK(sky->color({0, 0, -3}).g == Approx(1 - 0.5 / 32));
}

TEST_CASE("an environment has no seam, and is between its pixels in between") {
  const Environment sky(4, 1, {1, 1, 1, 0, 0, 0, 0, 0, 0, 0.5, 0.5, 0.5});
  const Rgb left = sky.color({-1e-9, -1, 0});
  const Rgb right = sky.color({1e-9, -1, 0});
  CHECK(left.r == Approx(0.75));
  CHECK(right.r == Approx(0.75));
}

TEST_CASE("every kind of picture brings the light that it was written from, floats as they are, 8 bits out of sRGB") {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("csgcast-sky-" + std::to_string(::getpid()));
  fs::create_directory(folder);
  Film film(60, 30, FilmContent::color);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 60; ++x) film.set(x, y, {0.2, 0.5, 0.9});
  }
  const Scene scene = compile(sphere(1));
  SceneDescription description;
  const auto seen = [&](const std::string& name) {
    description.background_image = BackgroundImage{(folder / name).string()};
    return make_view(description, scene, 1).sky({1, 2, 3});
  };
  for (const auto& [name, bits, error] : std::vector<std::tuple<const char*, int, double>>{{"a.exr", 32, 1e-7},
                                                                                           {"a.tif", 32, 1e-7},
                                                                                           {"a.hdr", 32, 1.0 / 128},
                                                                                           {"a.png", 8, 1.0 / 128},
                                                                                           {"a.png", 16, 1e-4},
                                                                                           {"a.tif", 8, 1.0 / 128},
                                                                                           {"a.tga", 8, 1.0 / 128},
                                                                                           {"a.webp", 8, 1.0 / 128}}) {
    INFO(name << " with " << bits << " bits");
    write_image(film, (folder / name).string(), {.bits = bits});
    const Rgb light = seen(name);
    CHECK(std::fabs(light.r - 0.2) <= error);
    CHECK(std::fabs(light.g - 0.5) <= error);
    CHECK(std::fabs(light.b - 0.9) <= error);
  }
  // An icon may be written, but OpenImageIO does not read it well, whatever its name says.
  write_image(film, (folder / "a.ico").string());
  CHECK_THROWS_WITH(seen("a.ico"), Catch::Contains("icons are not read"));
  fs::rename(folder / "a.ico", folder / "b.png");
  CHECK_THROWS_AS(seen("b.png"), Error);
  fs::remove_all(folder);
}

TEST_CASE("a mirror shows the environment in the reflected direction, and packets show what single rays do") {
  Material mirror;
  mirror.ambient = mirror.diffuse = mirror.specular = 0;
  mirror.reflection = 1;
  const Scene scene = compile(with_look(sphere(1), {mirror, {}}));
  const auto sky = ramp(128, 64);
  const View view = view_of(sky);
  RenderOptions options;
  options.width = 60;
  options.height = 40;
  options.samples = 4;
  const Film film = render(scene, view, options);
  options.engine = Engine::scalar;
  CHECK(render(scene, view, options).values() == film.values());
  options.samples = 1;
  const Film single = render(scene, view, options);
  const Camera camera(view.camera, options.width, options.height);
  int reflected = 0;
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      const Ray ray = camera.ray(x + 0.5, y + 0.5);
      const Vector d = ray.direction();
      const Vector o = ray.origin() - Point{};
      const double b = dot(o, d);
      const double root = b * b - dot(o, o) + 1;
      Vector seen = d;
      if (root > 0) {
        const Vector n = o + (-b - std::sqrt(root)) * d;
        seen = d - 2 * dot(d, n) * n;
        ++reflected;
      }
      const Rgb wanted = sky->color(seen);
      const Rgb got = single.rgb(x, y);
      CHECK(std::fabs(wanted.r - got.r) + std::fabs(wanted.g - got.g) < 1e-5);
    }
  }
  CHECK(reflected > 100);
}

TEST_CASE("alpha is the share of a pixel that shows the solid, and the background is taken out") {
  const Scene scene = compile(box({1, 1, 1}, Centering::centered));
  View view = view_of(nullptr);
  view.background = {0.2, 0.4, 0.6};
  view.camera.height = 4;
  RenderOptions options;
  options.width = options.height = 42;
  options.samples = 16;
  const Film plain = render(scene, view, options);
  double told = 0;
  options.progress = [&told](const Progress& progress) {
    CHECK(progress.share >= told);
    told = progress.share;
    return true;
  };
  const Film film = render_with_alpha(scene, view, options);
  CHECK(told == 1);
  options.progress = {};
  double covered = 0;
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      const double alpha = double(film.value(x, y, 3));
      covered += alpha;
      for (int c = 0; c < 3; ++c) {
        const double background = c == 0 ? 0.2 : c == 1 ? 0.4 : 0.6;
        CHECK(std::fabs(double(film.value(x, y, c)) + (1 - alpha) * background - double(plain.value(x, y, c))) < 1e-6);
        if (alpha == 0) CHECK(film.value(x, y, c) == 0);
      }
    }
  }
  // The cube's face is a quarter of the picture's height: 10.5 pixels, that is 42 of 168 samples along each axis.
  CHECK(covered == Approx(10.5 * 10.5).epsilon(0.05));
  options.mode = Mode::depth;
  CHECK_THROWS_AS(render_with_alpha(scene, view, options), Error);
}

TEST_CASE("channels tell what the modes show, and where, of which part and surface") {
  const Scene scene = compile(named(box({1, 1, 1}, Centering::centered), {"cube", 1}) +
                              transformed(sphere(0.5), translation({2, 0, 0})));
  const View view = view_of(nullptr);
  RenderOptions options;
  options.width = 48;
  options.height = 32;
  const std::vector<Channel> wanted{Channel::depth, Channel::normal, Channel::position,
                                    Channel::id,    Channel::part,   Channel::leaf};
  const std::vector<Film> films = channel_films(scene, view, options, wanted);
  options.mode = Mode::depth;
  CHECK(render(scene, view, options).values() == films[0].values());
  options.mode = Mode::id;
  CHECK(render(scene, view, options).values() == films[5].values());
  const Camera camera(view.camera, options.width, options.height);
  int cube = 0, ball = 0;
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      const bool sees = std::isfinite(films[0].value(x, y));
      CHECK((films[3].value(x, y) >= 0) == sees);
      if (!sees) {
        CHECK(std::isnan(films[2].value(x, y)));
        CHECK(films[4].value(x, y) == -1);
        continue;
      }
      const Point p = camera.ray(x + 0.5, y + 0.5).at(double(films[0].value(x, y)));
      for (int c = 0; c < 3; ++c) CHECK(std::fabs(double(films[2].value(x, y, c)) - p[std::size_t(c)]) < 1e-5);
      (films[4].value(x, y) == 0 ? cube : ball) += 1;
    }
  }
  CHECK((cube > 50 && ball > 50));
  options.engine = Engine::scalar;
  const std::vector<Film> scalar = channel_films(scene, view, options, wanted);
  for (const std::size_t i : {0U, 1U, 3U, 4U, 5U}) CHECK(scalar[i].values() == films[i].values());
}
