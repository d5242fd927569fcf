// SPDX-License-Identifier: MIT
// No place is special: a scene far from the origin makes the same picture.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "shade/trace/render.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/examples.h"

using namespace csgcast;

namespace {

View moved(View view, Vector offset) {
  view.camera.eye = view.camera.eye + offset;
  view.camera.look_at = view.camera.look_at + offset;
  for (LightDescription& light : view.lights)
    if (light.position) light.position = *light.position + offset;
  return view;
}

// Pixels of which a channel of the encoded picture differs by more than 1/255.
int differing_pixels(const Film& a, const Film& b) {
  const auto encoded = [](float linear) { return srgb_from_linear(std::clamp(static_cast<double>(linear), 0.0, 1.0)); };
  int count = 0;
  for (std::size_t pixel = 0; pixel < a.values().size(); pixel += 3) {
    double most = 0;
    for (std::size_t k = pixel; k < pixel + 3; ++k)
      most = std::max(most, std::fabs(encoded(a.values()[k]) - encoded(b.values()[k])));
    count += most > 1.0 / 255;
  }
  return count;
}

int differing_when_moved(const std::string& name, Vector offset, int side) {
  const SceneDescription description = test::example(name);
  const Scene scene = compile(description.solid);
  const View view = make_view(description, scene, 1);
  RenderOptions options;
  options.width = options.height = side;
  const Film there = render(compile(transformed(description.solid, translation(offset))), moved(view, offset), options);
  return differing_pixels(render(scene, view, options), there);
}

}  // namespace

TEST_CASE("an example scene moved by millions of its unit, camera and lights with it, makes the same picture") {
  // Up to 10 of 512 x 512 pixels may be at edges that the rounding of the camera's own place moves.
  const int side = test::long_run() ? 512 : 96;
  const int allowed = test::long_run() ? 10 : 1;
  for (const std::string& name : test::example_names()) {
    const int differing = differing_when_moved(name, {1e6, -2e6, 5e5}, side);
    if (test::long_run()) WARN(fmt::format("{}: {} of {} x {} pixels differ", name, differing, side, side));
    CAPTURE(name);
    CHECK(differing <= allowed);
  }
}
