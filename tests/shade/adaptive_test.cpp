// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "csg/base/error.h"
#include "shade/film/contrast.h"
#include "tests/shade/models.h"
#include "tests/support/effort.h"
#include "tests/support/examples.h"

using namespace csgcast;
using namespace csgcast::test;

namespace {

constexpr int width = 121;  // neither is a whole number of tiles
constexpr int height = 83;

RenderOptions with_samples(int samples, Sampling sampling = Sampling::regular) {
  RenderOptions options = picture(width, height);
  options.samples = samples;
  options.sampling = sampling;
  options.threads = 1;
  return options;
}

/// One of the examples, as it is looked at.
struct Example {
  explicit Example(const std::string& name)
      : description(example(name)),
        scene(compile(description.solid, Welding::derived())),
        view(make_view(description, scene, double(width) / height)) {}

  SceneDescription description;
  Scene scene;
  View view;
};

/// How much two pixels differ, of a film or of two: the largest difference of a channel as it is perceived.
float contrast(const Film& a, int ax, int ay, const Film& b, int bx, int by) {
  float most = 0;
  for (int c = 0; c < 3; ++c) {
    const float one = detail::perceived(a.value(ax, ay, c));
    most = std::max(most, std::fabs(one - detail::perceived(b.value(bx, by, c))));
  }
  return most;
}

double root_mean_square(const Film& a, const Film& b) {
  double sum = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) sum += std::pow(contrast(a, x, y, b, x, y), 2);
  return std::sqrt(sum / (width * height));
}

bool stands_out(const Film& film, int x, int y) {
  for (int j = std::max(y - 1, 0); j < std::min(y + 2, height); ++j) {
    for (int i = std::max(x - 1, 0); i < std::min(x + 2, width); ++i)
      if (contrast(film, x, y, film, i, j) > detail::least_contrast) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("adaptive samples are all taken where a pixel stands out, and one, at the centre, where nothing does") {
  for (const std::string name : {"die", "flange", "sponge"}) {
    INFO(name);
    const Example it(name);
    const Film centers = render(it.scene, it.view, with_samples(1));
    const Film full = render(it.scene, it.view, with_samples(9));
    RenderReport report;
    const Film adaptive = render(it.scene, it.view, with_samples(9, Sampling::adaptive), &report);
    std::uint64_t standing_out = 0;
    std::uint64_t changed = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const Rgb color = adaptive.rgb(x, y);
        const bool all = color == full.rgb(x, y);
        REQUIRE((all || color == centers.rgb(x, y)));
        changed += color == centers.rgb(x, y) ? 0 : 1;
        if (!stands_out(centers, x, y)) continue;
        ++standing_out;
        REQUIRE(all);
      }
    }
    CHECK(standing_out > 0);
    CHECK(report.refined_pixels >= standing_out);
    CHECK(report.refined_pixels >= changed);
    CHECK(report.refined_pixels < width * height);
  }
}

TEST_CASE("an adaptive picture is the same bit for bit on any number of threads and with either engine") {
  for (const std::string name : {"bearing", "die", "lamps", "sponge"}) {
    if (is_sanitized && name != "die") continue;
    INFO(name);
    const Example it(name);
    RenderOptions options = with_samples(4, Sampling::adaptive);
    RenderReport one;
    const Film expected = render(it.scene, it.view, options, &one);
    for (const Engine engine : {Engine::packets, Engine::scalar}) {
      for (const int threads : {1, 2, 8}) {
        if (test::is_sanitized && threads == 1) continue;
        options.engine = engine;
        options.threads = threads;
        RenderReport report;
        CHECK(render(it.scene, it.view, options, &report).values() == expected.values());
        CHECK(report.refined_pixels == one.refined_pixels);
        CHECK(report.rays.primary + report.skipped.primary_beyond_bounds ==
              one.rays.primary + one.skipped.primary_beyond_bounds);
        CHECK(report.rays.shadow == one.rays.shadow);
      }
    }
  }
}

TEST_CASE("few samples are taken of what is flat, and each that is not is counted") {
  View view = standard_view();
  view.camera = {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 30, 8.3};
  view.lights = {sun({0, 0, -1})};
  const Scene scene = compile(painted(box({5, 5, 1}, Centering::centered), matte()));
  RenderReport report;
  const Film adaptive = render(scene, view, with_samples(16, Sampling::adaptive), &report);
  CHECK(adaptive.values() == render(scene, view, with_samples(16)).values());
  // The square is 50 pixels wide: a pixel inside and one outside all around are less than 8 x 52.
  CHECK(report.refined_pixels > 4 * 50);
  CHECK(report.refined_pixels < 8 * 52);
  CHECK(report.rays.primary < 2 * width * height);
  CHECK(report.rays.primary + report.skipped.primary_beyond_bounds + report.skipped.primary_like_neighbours ==
        16 * width * height + report.refined_pixels);
}

TEST_CASE("a thin line is followed through pixels whose centres miss it") {
  // A fifth of a pixel thick, it rises by a pixel over sixteen: it misses most centres.
  Material glow = matte();
  glow.emission = {1, 1, 1};
  const double angle = std::atan(1.0 / 16) * 180 / 3.141592653589793;
  const Scene scene =
      compile(painted(transformed(box({300, 0.2, 0.2}, Centering::centered), rotation(Vector{0, 0, angle})), glow));
  View view = standard_view();
  view.camera = {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 30, double(height)};  // a pixel is 1 wide
  view.background = {};
  view.lights.clear();
  for (const Engine engine : {Engine::packets, Engine::scalar}) {
    RenderOptions options = with_samples(64);
    options.engine = engine;
    const Film full = render(scene, view, options);
    options.sampling = Sampling::adaptive;
    options.threads = 2;
    RenderReport report;
    CHECK(render(scene, view, options, &report).values() == full.values());
    CHECK(report.refined_pixels < 6 * width);
  }
}

TEST_CASE("an adaptive picture is nearer to the regular one than eight bits are, one sample a pixel is not") {
  constexpr double eight_bits = 0.5 / 255;
  for (const std::string name : {"bearing", "die", "flange", "quadrics"}) {
    if (is_sanitized && name != "die") continue;
    INFO(name);
    const Example it(name);
    const Film full = render(it.scene, it.view, with_samples(16));
    CHECK(root_mean_square(render(it.scene, it.view, with_samples(16, Sampling::adaptive)), full) < eight_bits);
    CHECK(root_mean_square(render(it.scene, it.view, with_samples(1)), full) > eight_bits);
  }
}

TEST_CASE("adaptive samples of one a pixel are regular ones, and other modes than shaded have none") {
  const Scene scene = compile(angel());
  RenderReport report;
  const Film one = render(scene, standard_view(), with_samples(1, Sampling::adaptive), &report);
  CHECK(one.values() == render(scene, standard_view(), with_samples(1)).values());
  CHECK(report.refined_pixels == 0);
  CHECK(report.skipped.primary_like_neighbours == 0);
  RenderOptions options = with_samples(4, Sampling::adaptive);
  options.mode = Mode::edges;
  CHECK_THROWS_AS(render(scene, standard_view(), options), Error);
}

TEST_CASE("the progress of an adaptive picture ascends to 1") {
  RenderOptions options = with_samples(4, Sampling::adaptive);
  std::vector<double> told;
  options.progress = [&](const Progress& progress) {
    told.push_back(progress.share);
    return true;
  };
  render(compile(angel()), standard_view(), options);
  REQUIRE(std::is_sorted(told.begin(), told.end()));
  REQUIRE(told.back() == 1);
}
