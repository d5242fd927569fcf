// SPDX-License-Identifier: MIT
// A part of a picture is bit for bit what it is in the whole.
#include <array>
#include <cstring>
#include <random>

#include "csg/base/error.h"
#include "tests/shade/models.h"
#include "tests/support/effort.h"
#include "tests/support/examples.h"

using namespace csgcast;
using namespace csgcast::test;

namespace {

bool is_part(const Film& part, const Film& whole, const PixelRegion& region) {
  if (part.width() != region.width() || part.height() != region.height()) return false;
  const auto bytes = sizeof(float) * static_cast<std::size_t>(part.width() * channels(part.content()));
  for (int y = 0; y < part.height(); ++y) {
    const auto row = [](const Film& film, int x, int line) {
      const auto at = static_cast<std::size_t>(line) * static_cast<std::size_t>(film.width()) + std::size_t(x);
      return film.values().data() + at * std::size_t(channels(film.content()));
    };
    if (std::memcmp(row(part, 0, y), row(whole, region.x0, region.y0 + y), bytes) != 0) return false;
  }
  return true;
}

void compare_regions(const Scene& scene, const View& view, RenderOptions options) {
  const int w = options.width;
  const int h = options.height;
  const Film whole = render(scene, view, options);
  std::vector<PixelRegion> regions{{0, 0, w, h}, {0, 0, 1, 1}, {w - 1, h - 1, w, h}, {w / 2, 0, w / 2 + 1, h}};
  for (int i = 0; i < 5; ++i) regions.push_back(band_of_picture(w, h, i, 5));
  std::mt19937 random(7);
  for (int i = 0; i < times(8); ++i) {
    const auto pick = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
    const int x = pick(0, w - 1);
    const int y = pick(0, h - 1);
    regions.push_back({x, y, pick(x + 1, w), pick(y + 1, h)});
  }
  for (const PixelRegion& region : regions) {
    INFO(region.x0 << "," << region.y0 << " to " << region.x1 << "," << region.y1);
    options.region = region;
    CHECK(is_part(render(scene, view, options), whole, region));
  }
}

}  // namespace

TEST_CASE("a region of a picture is bit for bit that part of the whole, in every mode and by either engine") {
  const SceneDescription description = example("die");
  const Scene scene = compile(description.solid, Welding::derived());
  const View view = make_view(description, scene, 61.0 / 47);
  for (const Mode mode : {Mode::shaded, Mode::edges, Mode::xray, Mode::depth, Mode::normal, Mode::id}) {
    for (const Engine engine : {Engine::packets, Engine::scalar}) {
      RenderOptions options = picture(61, 47);
      options.mode = mode;
      options.samples = 4;
      options.engine = engine;
      compare_regions(scene, view, options);
    }
  }
}

TEST_CASE("a region with adaptive samples is that part of the whole adaptive picture") {
  for (const char* name : {"die", "flange", "still-life"}) {
    if (is_sanitized && name != std::string("die")) continue;
    INFO(name);
    const SceneDescription description = example(name);
    const Scene scene = compile(description.solid, Welding::derived());
    const View view = make_view(description, scene, 121.0 / 63);
    RenderOptions options = picture(121, 63);
    options.sampling = Sampling::adaptive;
    options.samples = 16;
    compare_regions(scene, view, options);
  }
}

// Thin bars that no centre of a pixel sees for long ways: what varies is found by following them from pixel to pixel.
TEST_CASE("a region with adaptive samples follows thin lines that come from far beyond it") {
  std::vector<Solid> bars;
  for (int i = 0; i < 12; ++i) {
    const Solid bar = transformed(box({40, 0.02, 0.02}, Centering::centered), rotation(3.0 + 14 * i, {0, 0, 1}));
    bars.push_back(transformed(bar, translation({0.3 * i, 0.37 * i - 2, 0})));
  }
  const Scene scene = compile(unite(bars));
  SceneDescription description;
  description.camera = CameraDescription{.eye = {0, 0, 9}, .look_at = {0, 0, 0}, .up = {0, 1, 0}, .height = 8};
  const View view = make_view(description, scene, 1);
  RenderOptions options = picture(101, 101);
  options.sampling = Sampling::adaptive;
  options.samples = 36;
  compare_regions(scene, view, options);
}

TEST_CASE("regions that are empty or not within the picture are refused, and bands cut all of it once") {
  const Scene scene = compile(box({1, 1, 1}, Centering::centered));
  const View view = make_view({}, scene, 1);
  for (const PixelRegion region :
       std::array<PixelRegion, 5>{{{0, 0, 0, 0}, {-1, 0, 5, 5}, {0, 0, 11, 5}, {5, 5, 4, 6}, {0, 3, 4, 3}}}) {
    RenderOptions options = picture(10, 10);
    options.region = region;
    CHECK_THROWS_AS(render(scene, view, options), Error);
  }
  for (const int count : {1, 3, 7, 10}) {
    int next = 0;
    for (int i = 0; i < count; ++i) {
      const PixelRegion band = band_of_picture(8, 10, i, count);
      CHECK((band.x0 == 0 && band.x1 == 8 && band.y0 == next && band.height() >= 10 / count));
      next = band.y1;
    }
    CHECK(next == 10);
  }
  CHECK_THROWS_AS(band_of_picture(8, 10, 0, 11), Error);
  CHECK_THROWS_AS(band_of_picture(8, 10, 3, 3), Error);
  CHECK_THROWS_AS(band_of_picture(8, 10, -1, 3), Error);
}
